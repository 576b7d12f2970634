// Takes numbers and bytes off the front of a fuzzer's input.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foveola::test {

using Bytes = std::span<const std::uint8_t>;

/// Up to `size` bytes: fewer where the input ends.
inline Bytes take(Bytes& input, std::size_t size) {
  const Bytes taken = input.first(std::min(size, input.size()));
  input = input.subspan(taken.size());
  return taken;
}

/// A number of up to `digits` bytes, the lowest first.
inline std::uint64_t take_number(Bytes& input, std::size_t digits) {
  std::uint64_t number = 0;
  int bits = 0;
  for (const std::uint8_t byte : take(input, digits)) {
    number |= std::uint64_t{byte} << bits;
    bits += 8;
  }
  return number;
}

}  // namespace foveola::test
