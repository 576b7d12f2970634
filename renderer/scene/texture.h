// A two-dimensional image on a surface, kept in the 8 bits that it came with.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

enum class Wrap : std::uint8_t { repeat, clamp_to_edge, mirrored_repeat };

/// Four 8-bit channels (red, green, blue, alpha), row-major, first row at v = 0 (glTF's top).
class Texture {
 public:
  /// texels: 4 * width * height bytes. is_srgb: whether red, green and blue are sRGB-encoded;
  /// alpha never is.
  Texture(int width, int height, std::vector<std::uint8_t> texels, bool is_srgb, Wrap wrap_u,
          Wrap wrap_v);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Bilinearly filtered linear value at `uv`, whatever its magnitude; texel centres lie at
  /// half-integers. A non-finite uv reads texel (0, 0).
  Vec4 sample(const Vec2& uv) const;
  Vec4 sample(const Vec2& uv, float) const { return sample(uv); }

 private:
  Vec4 texel(int x, int y) const;

  int width_;
  int height_;
  std::vector<std::uint8_t> texels_;
  const float* linear_from_byte_;  ///< 256 values that live as long as the program
  Wrap wrap_u_;
  Wrap wrap_v_;
};

}  // namespace foveola
