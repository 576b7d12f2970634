// Reads and writes numbers of files: little-endian, without gaps, on every machine.
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <climits>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"

namespace foveola {

inline void append(std::string& bytes, std::unsigned_integral auto value) {
  std::array<char, sizeof value> raw;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    raw[i] = static_cast<char>((value >> (i * CHAR_BIT)) & 0xFFU);
  }
  bytes.append(raw.data(), raw.size());
}
inline void append(std::string& bytes, float value) {
  append(bytes, std::bit_cast<std::uint32_t>(value));
}
inline void append(std::string& bytes, double value) {
  append(bytes, std::bit_cast<std::uint64_t>(value));
}
inline void append(std::string& bytes, Nanoseconds value) {
  append(bytes, static_cast<std::uint64_t>(value.count()));
}
inline void append(std::string& bytes, const Vec3& value) {
  append(bytes, value.x);
  append(bytes, value.y);
  append(bytes, value.z);
}

/// Removes a number from the front of `bytes`, which holds at least one.
template <std::unsigned_integral Number>
Number take(std::string_view& bytes) {
  assert(bytes.size() >= sizeof(Number));
  Number value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    value |= static_cast<Number>(static_cast<unsigned char>(bytes[i])) << (i * CHAR_BIT);
  }
  bytes.remove_prefix(sizeof value);
  return value;
}
inline float take_float(std::string_view& bytes) {
  return std::bit_cast<float>(take<std::uint32_t>(bytes));
}
inline double take_double(std::string_view& bytes) {
  return std::bit_cast<double>(take<std::uint64_t>(bytes));
}
inline Nanoseconds take_nanoseconds(std::string_view& bytes) {
  return Nanoseconds(static_cast<std::int64_t>(take<std::uint64_t>(bytes)));
}

}  // namespace foveola
