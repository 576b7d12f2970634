#include "renderer/film/rounded_log2.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace foveola {
namespace {

constexpr int mantissa_bits = 52;
constexpr std::uint64_t bias = 1023;
constexpr std::uint64_t bits_of_one = bias << mantissa_bits;

/// The integer as a double: numbers from 2^52 on are a unit apart, and their bits count them.
double double_of(std::uint64_t small) {
  constexpr std::uint64_t bits_of_2_to_52 = (bias + mantissa_bits) << mantissa_bits;
  constexpr double two_to_52 = 4503599627370496.0;
  return std::bit_cast<double>(bits_of_2_to_52 | small) - two_to_52;
}

/// log2 within 1e-14, without branches or calls, so that compilers make several at a time: the
/// exponent, and of a mantissa m in [sqrt(1/2), sqrt(2)) the series
/// ln m = 2 (s + s^3/3 + s^5/5 + ...) with s = (m - 1) / (m + 1).
double near_log2(double number) {
  constexpr std::uint64_t bits_of_root_of_half = 0x3FE6A09E667F3BCD;
  const auto bits = std::bit_cast<std::uint64_t>(number);
  const std::uint64_t biased_exponent =
      (bits - bits_of_root_of_half + bits_of_one) >> mantissa_bits;
  const double exponent = double_of(biased_exponent) - static_cast<double>(bias);
  const auto m = std::bit_cast<double>(bits - (biased_exponent << mantissa_bits) + bits_of_one);
  const double s = (m - 1.0) / (m + 1.0);
  const double z = s * s;
  const double series =
      1.0 +
      z * (1.0 / 3 +
           z * (1.0 / 5 +
                z * (1.0 / 7 +
                     z * (1.0 / 9 +
                          z * (1.0 / 11 + z * (1.0 / 13 + z * (1.0 / 15 + z * (1.0 / 17))))))));
  return exponent + 2.0 * std::numbers::log2e * s * series;
}

}  // namespace

void rounded_log2(std::span<const double> numbers, std::span<float> logs) {
  assert(numbers.size() == logs.size());
  // Where all that is as near rounds to one float, so does the library's.
  constexpr double margin = 1e-12;
  constexpr std::size_t block = 64;
  for (std::size_t begin = 0; begin < numbers.size(); begin += block) {
    const std::size_t end = std::min(begin + block, numbers.size());
    int doubtful = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double log = near_log2(numbers[i]);
      logs[i] = static_cast<float>(log - margin);
      doubtful += logs[i] == static_cast<float>(log + margin) ? 0 : 1;
    }
    for (std::size_t i = begin; doubtful > 0 && i < end; ++i) {
      logs[i] = static_cast<float>(std::log2(numbers[i]));
    }
  }
}

}  // namespace foveola
