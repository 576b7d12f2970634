#include "renderer/scene/textures/texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "renderer/scene/textures/srgb.h"

namespace foveola {
namespace {

/// The two texels along one axis around a coordinate.
struct Taps {
  int first;
  int second;
  float weight_second;
};

Taps repeated_taps(float coordinate, int size) {
  const float position = (coordinate - std::floor(coordinate)) * static_cast<float>(size) - 0.5F;
  const float below = std::floor(position);
  const int first = static_cast<int>(below);
  return {.first = first < 0 ? size - 1 : first,
          .second = first + 1 < size ? first + 1 : 0,
          .weight_second = position - below};
}

Taps clamped_taps(float coordinate, int size) {
  const float position = std::clamp(coordinate, 0.0F, 1.0F) * static_cast<float>(size) - 0.5F;
  const float below = std::floor(position);
  const int first = static_cast<int>(below);
  return {.first = std::max(first, 0),
          .second = std::min(first + 1, size - 1),
          .weight_second = position - below};
}

/// Folds the period of two images into one; at the folds a mirrored image meets its own edge texel,
/// like a clamped one.
float mirrored(float coordinate) {
  const float within_period = coordinate - 2.0F * std::floor(0.5F * coordinate);
  return within_period > 1.0F ? 2.0F - within_period : within_period;
}

Taps taps(float coordinate, int size, Wrap wrap) {
  switch (wrap) {
    case Wrap::clamp_to_edge:
      return clamped_taps(coordinate, size);
    case Wrap::mirrored_repeat:
      return clamped_taps(mirrored(coordinate), size);
    case Wrap::repeat:
      break;
  }
  return repeated_taps(coordinate, size);
}

/// The texel that holds the coordinate is the nearer of the two.
Taps nearest(const Taps& taps) {
  const int texel = taps.weight_second < 0.5F ? taps.first : taps.second;
  return {.first = texel, .second = texel, .weight_second = 0.0F};
}

/// Unlike a weighted sum, exact for equal ends.
template <typename T>
T interpolate(const T& from, const T& to, float weight) {
  return from + weight * (to - from);
}

/// The same for texels whose last value is an opacity, which weights the colours.
template <typename T>
T interpolate_visible(const T& from, const T& to, float weight) {
  constexpr int alpha = T::length() - 1;
  if (from[alpha] == to[alpha]) {
    return interpolate(from, to, weight);
  }
  const float opacity = interpolate(from[alpha], to[alpha], weight);
  T texel = interpolate(from, to, opacity > 0.0F ? weight * to[alpha] / opacity : weight);
  texel[alpha] = opacity;
  return texel;
}

template <int channels>
using Texel = glm::vec<channels, float>;

/// Light, and alpha from 0 to 255: it is linear, and can be scaled once after filtering.
template <int channels>
Texel<channels> decode(const std::uint8_t* codes, const float* linear_from_byte) {
  Texel<channels> texel;
  for (int i = 0; i < channels; ++i) {
    const bool is_alpha = channels % 2 == 0 && i == channels - 1;
    texel[i] = is_alpha ? static_cast<float>(codes[i]) : linear_from_byte[codes[i]];
  }
  return texel;
}

template <int channels>
Vec4 expand(const Texel<channels>& texel) {
  if constexpr (channels == 1) {
    return {texel[0], texel[0], texel[0], 1.0F};
  } else if constexpr (channels == 2) {
    return {texel[0], texel[0], texel[0], texel[1] / 255.0F};
  } else if constexpr (channels == 3) {
    return {texel, 1.0F};
  } else {
    return {texel[0], texel[1], texel[2], texel[3] / 255.0F};
  }
}

/// Bilinear filter of the four texels at u and v. linear_from_byte: 256 linear values by sRGB byte.
/// has_opacity: the last channel weights the colours.
template <int channels, bool has_opacity = false>
Vec4 filter_bilinear(const std::uint8_t* codes, int width, const float* linear_from_byte,
                     const Taps& u, const Taps& v) {
  const std::uint8_t* upper_row = codes + static_cast<std::ptrdiff_t>(v.first) * width * channels;
  const std::uint8_t* lower_row = codes + static_cast<std::ptrdiff_t>(v.second) * width * channels;
  const auto texel = [&](const std::uint8_t* row, int x) {
    return decode<channels>(row + static_cast<std::ptrdiff_t>(x) * channels, linear_from_byte);
  };
  const auto mix = [](const auto& from, const auto& to, float weight) {
    if constexpr (has_opacity) {
      return interpolate_visible(from, to, weight);
    } else {
      return interpolate(from, to, weight);
    }
  };
  const Texel<channels> upper =
      mix(texel(upper_row, u.first), texel(upper_row, u.second), u.weight_second);
  const Texel<channels> lower =
      mix(texel(lower_row, u.first), texel(lower_row, u.second), u.weight_second);
  return expand<channels>(mix(upper, lower, v.weight_second));
}

}  // namespace

Texels::Texels(DecodedImage image, bool is_srgb, bool with_mips, bool has_opacity)
    : codes_(std::move(image.texels)),
      channels_(image.channels),
      is_srgb_(is_srgb),
      has_opacity_(has_opacity && image.channels % 2 == 0) {
  assert(image.width > 0 && image.height > 0 && channels_ >= 1 && channels_ <= 4);
  assert(codes_.size() == static_cast<std::size_t>(channels_) * image.width * image.height);
  if (with_mips) {
    levels_ = append_mip_chain(codes_, image.width, image.height, channels_, is_srgb, has_opacity_);
  } else {
    levels_ = {{.width = image.width, .height = image.height, .offset = 0}};
  }
}

std::size_t Texels::memory_bytes() const {
  return sizeof *this + codes_.capacity() + levels_.capacity() * sizeof(MipLevel);
}

Texture::Texture(std::shared_ptr<const Texels> texels, const Sampler& sampler)
    : texels_(std::move(texels)),
      levels_(texels_->levels()),
      codes_(texels_->codes()),
      linear_from_byte_(linear_from_byte(texels_->is_srgb()).data()),
      channels_(texels_->channels()),
      sampler_(sampler) {
  if (sampler.mip == MipFilter::none) {
    levels_ = levels_.first(1);
  }
}

Texture::Texture(DecodedImage image, bool is_srgb, const Sampler& sampler, bool with_mips)
    : Texture(std::make_shared<const Texels>(std::move(image), is_srgb,
                                             with_mips && sampler.mip != MipFilter::none),
              sampler) {}

Texture::Texture(int width, int height, std::vector<std::uint8_t> texels, bool is_srgb, Wrap wrap_u,
                 Wrap wrap_v)
    : Texture({.width = width, .height = height, .channels = 4, .texels = std::move(texels)},
              is_srgb, {.wrap_u = wrap_u, .wrap_v = wrap_v}) {}

Vec4 Texture::sample(const Vec2& uv) const {
  return sample_level(levels_[0], sampler_.magnification, uv);
}

Texture::Levels Texture::levels_for(float uv_width) const {
  const float texels = uv_width * static_cast<float>(std::max(width(), height()));
  if (!(texels > 1.0F) || !std::isfinite(uv_width)) {
    return {.finer = 0, .weight_coarser = 0.0F, .filter = sampler_.magnification};
  }
  const auto coarsest = static_cast<float>(levels_.size() - 1);
  const float level = std::min(std::log2(texels), coarsest);
  if (sampler_.mip != MipFilter::linear) {
    return {.finer = static_cast<std::size_t>(level + 0.5F),
            .weight_coarser = 0.0F,
            .filter = sampler_.minification};
  }
  const auto finer = static_cast<std::size_t>(level);
  return {.finer = finer,
          .weight_coarser = level - static_cast<float>(finer),
          .filter = sampler_.minification};
}

Vec4 Texture::sample(const Vec2& uv, float uv_width) const {
  const Levels levels = levels_for(uv_width);
  const Vec4 value = sample_level(levels_[levels.finer], levels.filter, uv);
  if (!(levels.weight_coarser > 0.0F)) {
    return value;
  }
  const Vec4 coarser = sample_level(levels_[levels.finer + 1], levels.filter, uv);
  return texels_->has_opacity() ? interpolate_visible(value, coarser, levels.weight_coarser)
                                : interpolate(value, coarser, levels.weight_coarser);
}

void Texture::prefetch(const Vec2& uv, float uv_width) const {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
    return;
  }
  const MipLevel& level = levels_[levels_for(uv_width).finer];
  const Taps u = taps(uv.x, level.width, sampler_.wrap_u);
  const Taps v = taps(uv.y, level.height, sampler_.wrap_v);
  for (const int row : {v.first, v.second}) {
    const std::ptrdiff_t texel = static_cast<std::ptrdiff_t>(row) * level.width + u.first;
    __builtin_prefetch(codes_ + level.offset + texel * channels_);
  }
}

Vec4 Texture::sample_level(const MipLevel& level, Filter filter, const Vec2& uv) const {
  Taps u{.first = 0, .second = 0, .weight_second = 0.0F};
  Taps v = u;
  if (std::isfinite(uv.x) && std::isfinite(uv.y)) {
    u = taps(uv.x, level.width, sampler_.wrap_u);
    v = taps(uv.y, level.height, sampler_.wrap_v);
  }
  if (filter == Filter::nearest) {
    u = nearest(u);
    v = nearest(v);
  }
  const std::uint8_t* codes = codes_ + level.offset;
  if (texels_->has_opacity()) {
    return channels_ == 2 ? filter_bilinear<2, true>(codes, level.width, linear_from_byte_, u, v)
                          : filter_bilinear<4, true>(codes, level.width, linear_from_byte_, u, v);
  }
  switch (channels_) {
    case 1:
      return filter_bilinear<1>(codes, level.width, linear_from_byte_, u, v);
    case 2:
      return filter_bilinear<2>(codes, level.width, linear_from_byte_, u, v);
    case 3:
      return filter_bilinear<3>(codes, level.width, linear_from_byte_, u, v);
    default:
      return filter_bilinear<4>(codes, level.width, linear_from_byte_, u, v);
  }
}

}  // namespace foveola
