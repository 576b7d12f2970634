#include "renderer/scene/texture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "renderer/scene/srgb.h"

namespace foveola {
namespace {

using ByteTable = std::array<float, 256>;

ByteTable make_table(double (*decode)(double)) {
  ByteTable table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<float>(decode(static_cast<double>(i) / 255.0));
  }
  return table;
}

const float* linear_from_byte(bool is_srgb) {
  static const ByteTable srgb = make_table(linear_from_srgb);
  static const ByteTable identity = make_table([](double value) { return value; });
  return (is_srgb ? srgb : identity).data();
}

/// The two texels along one axis that a coordinate lies between.
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

/// Folds the period of two images onto one; at the folds a mirrored image meets its own edge texel,
/// as a clamped one does.
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

/// Unlike a weighted sum, exact where both ends are equal.
Vec4 interpolate(const Vec4& from, const Vec4& to, float weight) {
  return from + weight * (to - from);
}

}  // namespace

Texture::Texture(int width, int height, std::vector<std::uint8_t> texels, bool is_srgb, Wrap wrap_u,
                 Wrap wrap_v)
    : width_(width),
      height_(height),
      texels_(std::move(texels)),
      linear_from_byte_(linear_from_byte(is_srgb)),
      wrap_u_(wrap_u),
      wrap_v_(wrap_v) {
  assert(width > 0 && height > 0);
  assert(texels_.size() == std::size_t{4} * width * height);
}

Vec4 Texture::sample(const Vec2& uv) const {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
    return texel(0, 0);
  }
  const Taps u = taps(uv.x, width_, wrap_u_);
  const Taps v = taps(uv.y, height_, wrap_v_);
  const Vec4 upper =
      interpolate(texel(u.first, v.first), texel(u.second, v.first), u.weight_second);
  const Vec4 lower =
      interpolate(texel(u.first, v.second), texel(u.second, v.second), u.weight_second);
  return interpolate(upper, lower, v.weight_second);
}

Vec4 Texture::texel(int x, int y) const {
  const std::uint8_t* channels =
      texels_.data() + 4 * (static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x));
  return {linear_from_byte_[channels[0]], linear_from_byte_[channels[1]],
          linear_from_byte_[channels[2]], static_cast<float>(channels[3]) / 255.0F};
}

}  // namespace foveola
