#include "renderer/scene/textures/mip_chain.h"

#include <algorithm>
#include <array>

#include "renderer/base/work/work_scope.h"
#include "renderer/scene/textures/srgb.h"

namespace foveola {
namespace {

/// The texels along one axis under one texel of the next level: at most three, since it is at least
/// as wide as a third of them and begins at a multiple of its own width.
struct Cover {
  std::size_t first = 0;
  std::size_t count = 0;
  std::array<float, 3> weights{};  ///< which sum to 1
};

std::vector<Cover> covers(int size, int next_size) {
  std::vector<Cover> result;
  for (int i = 0; i < next_size; ++i) {
    // In units of 1 / next_size texels, all borders are whole numbers.
    const std::int64_t begin = std::int64_t{i} * size;
    const std::int64_t end = begin + size;
    Cover cover{.first = static_cast<std::size_t>(begin / next_size)};
    for (std::int64_t texel = begin / next_size; texel * next_size < end; ++texel) {
      const std::int64_t overlap =
          std::min(end, (texel + 1) * next_size) - std::max(begin, texel * next_size);
      cover.weights[cover.count++] = static_cast<float>(static_cast<double>(overlap) / size);
    }
    result.push_back(cover);
  }
  return result;
}

/// Converts between a level's codes and linear values, channel by channel.
class Codec {
 public:
  Codec(int channels, bool is_srgb, bool has_opacity)
      : channels_(static_cast<std::size_t>(channels)) {
    const std::size_t alpha = channels % 2 == 0 ? channels_ - 1 : channels_;
    opacity_ = has_opacity ? alpha : channels_;
    for (std::size_t channel = 0; channel < channels_; ++channel) {
      is_srgb_[channel] = is_srgb && channel != alpha;
      linear_[channel] = linear_from_byte(is_srgb_[channel]).data();
    }
  }

  std::size_t channels() const { return channels_; }
  float linear(std::uint8_t code, std::size_t channel) const { return linear_[channel][code]; }
  std::uint8_t code(float linear, std::size_t channel) const {
    return is_srgb_[channel] ? srgb_byte_from_linear(linear) : byte_from_linear(linear);
  }
  /// Index of the alpha that weights the other channels; channels() without one.
  std::size_t opacity() const { return opacity_; }

 private:
  std::size_t channels_;
  std::size_t opacity_;
  std::array<bool, 4> is_srgb_{};
  std::array<const float*, 4> linear_{};
};

/// Adds `weight` times a row of codes to the sums of its samples.
void add_row(std::vector<float>& sums, const std::uint8_t* codes, float weight,
             const Codec& codec) {
  const std::size_t opacity = codec.opacity();
  for (std::size_t i = 0; i < sums.size(); i += codec.channels()) {
    const float visible =
        opacity < codec.channels() ? weight * codec.linear(codes[i + opacity], opacity) : weight;
    for (std::size_t channel = 0; channel < codec.channels(); ++channel) {
      sums[i + channel] +=
          (channel == opacity ? weight : visible) * codec.linear(codes[i + channel], channel);
    }
  }
}

/// Rounding error of each channel so far, carried to the next texel: texels of a coarse level are
/// similar, and equal rounding would shift their mean.
using Carry = std::array<float, 4>;

void write_row(const std::vector<float>& sums, const std::vector<Cover>& columns,
               std::uint8_t* codes, const Codec& codec, Carry& carry) {
  for (const Cover& cover : columns) {
    const auto sum_onto = [&](float sum, std::size_t channel) {
      for (std::size_t i = 0; i < cover.count; ++i) {
        sum += cover.weights[i] * sums[(cover.first + i) * codec.channels() + channel];
      }
      return sum;
    };
    const std::size_t opacity = codec.opacity();
    const float visible = opacity < codec.channels() ? sum_onto(0.0F, opacity) : 1.0F;
    for (std::size_t channel = 0; channel < codec.channels(); ++channel) {
      const float weight = channel == opacity ? 1.0F : visible;
      const float sum = sum_onto(carry[channel], channel);
      const float mean = weight > 0.0F ? sum / weight : 0.0F;
      *codes = codec.code(std::clamp(mean, 0.0F, 1.0F), channel);
      carry[channel] = sum - weight * codec.linear(*codes, channel);
      ++codes;
    }
  }
}

void write_next_level(std::vector<std::uint8_t>& texels, const MipLevel& level,
                      const MipLevel& next, const Codec& codec) {
  const std::size_t row_bytes = codec.channels() * static_cast<std::size_t>(level.width);
  const std::vector<Cover> columns = covers(level.width, next.width);
  std::uint8_t* to = texels.data() + next.offset;
  std::vector<float> sums(row_bytes);
  Carry carry{};
  for (const Cover& rows : covers(level.height, next.height)) {
    throw_if_work_stopped();
    std::ranges::fill(sums, 0.0F);
    for (std::size_t i = 0; i < rows.count; ++i) {
      add_row(sums, texels.data() + level.offset + (rows.first + i) * row_bytes, rows.weights[i],
              codec);
    }
    write_row(sums, columns, to, codec, carry);
    to += codec.channels() * static_cast<std::size_t>(next.width);
  }
}

}  // namespace

std::vector<MipLevel> append_mip_chain(std::vector<std::uint8_t>& texels, int width, int height,
                                       int channels, bool is_srgb, bool has_opacity) {
  std::vector<MipLevel> levels{{.width = width, .height = height, .offset = 0}};
  std::size_t bytes = texels.size();
  for (;;) {
    const MipLevel next{.width = std::max(levels.back().width / 2, 1),
                        .height = std::max(levels.back().height / 2, 1),
                        .offset = bytes};
    const std::size_t count =
        static_cast<std::size_t>(next.width) * static_cast<std::size_t>(next.height);
    if (count < least_mip_texels) {
      break;
    }
    bytes += static_cast<std::size_t>(channels) * count;
    levels.push_back(next);
  }
  texels.reserve(bytes);
  texels.resize(bytes);
  const Codec codec(channels, is_srgb, has_opacity);
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    write_next_level(texels, levels[i], levels[i + 1], codec);
  }
  return levels;
}

}  // namespace foveola
