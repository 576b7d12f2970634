// The sRGB transfer function and its 8-bit codes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace foveola {

/// Linear value in [0, 1] of the sRGB-encoded value `encoded` in [0, 1] (IEC 61966-2-1).
inline double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// The linear value of each 8-bit code, sRGB or linear; lives as long as the program.
const std::array<float, 256>& linear_from_byte(bool is_srgb);

/// The 8-bit code nearest to `linear`, which is clamped to [0, 1]; 0 for NaN.
inline std::uint8_t byte_from_linear(float linear) {
  return static_cast<std::uint8_t>(255.0F * std::min(std::max(0.0F, linear), 1.0F) + 0.5F);
}

/// The 8-bit sRGB code nearest to the encoding of `linear`, which is clamped to [0, 1]; 0 for NaN.
std::uint8_t srgb_byte_from_linear(float linear);

}  // namespace foveola
