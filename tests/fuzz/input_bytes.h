// What the fuzzers' inputs have in common.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

namespace foveola::test {

using Bytes = std::span<const std::uint8_t>;

/// Ends the fuzzer with what was found wrong.
inline void check_that(bool holds, const char* what) {
  if (!holds) {
    throw std::logic_error(what);
  }
}

/// Takes up to `size` bytes off the input's front: fewer where the input ends.
inline Bytes take(Bytes& input, std::size_t size) {
  const Bytes taken = input.first(std::min(size, input.size()));
  input = input.subspan(taken.size());
  return taken;
}

/// Takes a number off it, of up to `digits` bytes, the lowest first.
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
