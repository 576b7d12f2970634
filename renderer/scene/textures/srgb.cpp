#include "renderer/scene/textures/srgb.h"

#include <cstddef>

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

/// Finds the code whose interval contains a linear value, starting at most two codes too low: the
/// codes are densest near black, 3294 per unit.
struct SrgbEncoder {
  static constexpr std::size_t buckets = 4096;
  std::array<float, 256> upper_end{};  ///< for each code, the largest linear value nearest to it
  std::array<std::uint8_t, buckets + 1> first_code{};

  SrgbEncoder() {
    for (std::size_t code = 0; code < 255; ++code) {
      upper_end[code] =
          static_cast<float>(linear_from_srgb((static_cast<double>(code) + 0.5) / 255.0));
    }
    upper_end[255] = 2.0F;
    std::uint8_t code = 0;
    for (std::size_t bucket = 0; bucket <= buckets; ++bucket) {
      while (upper_end[code] <= static_cast<float>(bucket) / static_cast<float>(buckets)) {
        ++code;
      }
      first_code[bucket] = code;
    }
  }

  std::uint8_t operator()(float linear) const {
    const float value = std::min(std::max(0.0F, linear), 1.0F);  // 0 for NaN
    std::uint8_t code = first_code[static_cast<std::size_t>(value * static_cast<float>(buckets))];
    while (upper_end[code] <= value) {
      ++code;
    }
    return code;
  }
};

}  // namespace

const std::array<float, 256>& linear_from_byte(bool is_srgb) {
  static const ByteTable srgb = make_table(linear_from_srgb);
  static const ByteTable identity = make_table([](double value) { return value; });
  return is_srgb ? srgb : identity;
}

std::uint8_t srgb_byte_from_linear(float linear) {
  static const SrgbEncoder encode;
  return encode(linear);
}

}  // namespace foveola
