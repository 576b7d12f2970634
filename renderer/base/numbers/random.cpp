#include "renderer/base/numbers/random.h"

#include <cmath>
#include <numbers>

namespace foveola {
namespace {

// Bits: 32-bit unsigned numbers, or lanes of them.

template <typename Bits>
constexpr Bits reverse_bits(Bits x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0x00ff00ffU) << 8) | ((x & 0xff00ff00U) >> 8);
  x = ((x & 0x0f0f0f0fU) << 4) | ((x & 0xf0f0f0f0U) >> 4);
  x = ((x & 0x33333333U) << 2) | ((x & 0xccccccccU) >> 2);
  return ((x & 0x55555555U) << 1) | ((x & 0xaaaaaaaaU) >> 1);
}

/// Each bit is flipped by a hash of the bits below it only, which on reversed bits is a nested
/// uniform scramble (constants of Vegdahl 2021, "Building a Better LK Hash").
template <typename Bits>
constexpr Bits laine_karras(Bits x, const Bits& seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

/// The second Sobol dimension with its bits reversed (the first, reversed, is the index itself).
/// Its generator matrix is Pascal's triangle modulo 2, so bit j is the sum of the bits i whose
/// binary digits contain those of j (Lucas 1878): a transform over the five digits of i.
template <typename Bits>
constexpr Bits reversed_sobol_dimension_1(Bits index) {
  index ^= (index & 0xaaaaaaaaU) >> 1;
  index ^= (index & 0xccccccccU) >> 2;
  index ^= (index & 0xf0f0f0f0U) >> 4;
  index ^= (index & 0xff00ff00U) >> 8;
  index ^= index >> 16;
  return index;
}

/// An Owen scramble of the number in [0, 1) whose first binary digit is the lowest bit of
/// `reversed`.
template <typename Bits>
inline auto scrambled(const Bits& reversed, const Bits& seed) {
  return unit_float(reverse_bits(laine_karras(reversed, seed)));
}

/// The index of a sample in the sequence of the dimension, or pair of dimensions, of `key`.
template <typename Bits>
inline Bits shuffled(const Bits& sample_number, const Bits& key) {
  return reverse_bits(laine_karras(reverse_bits(sample_number), key));
}
/// The first and the second number of those dimensions at `index` of the sequence.
template <typename Bits>
inline auto point_x(const Bits& index, const Bits& key) {
  return scrambled(index, mix(key));
}
template <typename Bits>
inline auto point_y(const Bits& index, const Bits& key) {
  return scrambled(reversed_sobol_dimension_1(index), mix(mix(key)));
}

constexpr std::uint64_t pcg_multiplier = 6364136223846793005ULL;

}  // namespace

Vec2 sobol_2d(std::uint64_t index, std::uint32_t seed) {
  const auto block = static_cast<std::uint32_t>(index >> 32);
  const auto i = static_cast<std::uint32_t>(index);
  const std::uint32_t key = mix(mix(seed), block);
  return {scrambled(i, mix(key, 0)), scrambled(reversed_sobol_dimension_1(i), mix(key, 1))};
}

float SampleStream::next_1d() {
  const std::uint32_t key = mix(key_, dimension_++);
  return point_x(shuffled(sample_number_, key), key);
}

Vec2 SampleStream::next_2d() {
  const std::uint32_t key = mix(key_, dimension_++);
  const std::uint32_t index = shuffled(sample_number_, key);
  return {point_x(index, key), point_y(index, key)};
}

Floats SampleStreams::next_1d() {
  const Uints key = mix(key_, next_dimension());
  return point_x(shuffled(sample_number_, key), key);
}

Vec2s SampleStreams::next_2d() {
  const Uints key = mix(key_, next_dimension());
  const Uints index = shuffled(sample_number_, key);
  return {point_x(index, key), point_y(index, key)};
}

Pcg32::Pcg32(std::uint64_t seed, std::uint64_t stream) : increment_((stream << 1) | 1U) {
  next();
  state_ += seed;
  next();
}

std::uint32_t Pcg32::next() {
  const std::uint64_t old = state_;
  state_ = old * pcg_multiplier + increment_;
  const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
  const auto rotation = static_cast<std::uint32_t>(old >> 59);
  return (shifted >> rotation) | (shifted << ((32U - rotation) & 31U));
}

std::uint32_t Pcg32::below(std::uint32_t bound) {
  const std::uint32_t threshold = (0U - bound) % bound;
  for (;;) {
    const std::uint32_t value = next();
    if (value >= threshold) {
      return value % bound;
    }
  }
}

double Pcg32::uniform() {
  const std::uint64_t high = next() >> 5;
  const std::uint64_t low = next() >> 6;
  return static_cast<double>((high << 26) | low) * 0x1p-53;
}

double Pcg32::normal() {
  const double radius = std::sqrt(2.0 * exponential());
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

double Pcg32::exponential() { return -std::log1p(-uniform()); }

}  // namespace foveola
