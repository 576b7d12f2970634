// Random numbers as functions of a key, so that results do not depend on threads or order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "renderer/base/numbers/lane_columns.h"
#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

/// 1 - 2^-24, the largest float below 1.
inline constexpr float largest_below_one = 0x1.fffffep-1F;

/// A bijective mixer of 32 bits ("lowbias32", Ellis 2018, "Prospecting for Hash Functions"). Bits:
/// 32-bit unsigned numbers, or lanes of them.
template <typename Bits>
constexpr Bits mixed(Bits x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  x ^= x >> 16;
  return x;
}
template <typename Bits>
constexpr Bits mixed(const Bits& state, const Bits& value) {
  return mixed<Bits>(state ^ (mixed<Bits>(value + 0x9e3779b9U) + 0x85ebca6bU));
}

constexpr std::uint32_t mix(std::uint32_t x) { return mixed(x); }
inline Uints mix(const Uints& x) { return mixed(x); }

/// Folds `value` into the running hash `state`.
constexpr std::uint32_t mix(std::uint32_t state, std::uint32_t value) {
  return mixed(state, value);
}
inline Uints mix(const Uints& state, const Uints& value) { return mixed(state, value); }

/// The 24 high bits as a float in [0, 1); never 1.
constexpr float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24F; }
inline Floats unit_float(const Uints& bits) { return floats_of(Ints(bits >> 8)) * 0x1p-24F; }

/// Point `index` of the two-dimensional Sobol sequence, Owen-scrambled by `seed` with the hash of
/// Burley 2020, "Practical Hash-based Owen Scrambling". Any 2^(a+b) consecutive points that start
/// at a multiple of 2^(a+b) put exactly one in each of the 2^a x 2^b equal boxes of the unit
/// square. Beyond 2^32 points the scramble changes and the sequence starts anew.
Vec2 sobol_2d(std::uint64_t index, std::uint32_t seed);

/// The random numbers of one path: number d is a function of (seed, pixel, sample number, d). Over
/// a pixel's sample numbers each dimension, or pair of dimensions, runs through a Sobol sequence
/// whose order and points are Owen-scrambled with a key of its own (Burley 2020, section 5).
class SampleStream {
 public:
  /// For assignment only.
  SampleStream() = default;
  SampleStream(std::uint32_t seed, std::uint32_t pixel, std::uint32_t sample_number)
      : key_(mix(mix(seed), pixel)), sample_number_(sample_number) {}

  float next_1d();
  Vec2 next_2d();
  /// 32 bits without any stratification over the sample numbers.
  std::uint32_t next_bits() { return mix(mix(key_, dimension_++), sample_number_); }

 private:
  template <std::size_t capacity>
  friend class SampleStreamColumns;

  std::uint32_t key_ = 0;
  std::uint32_t sample_number_ = 0;
  std::uint32_t dimension_ = 0;
};

/// Eight streams in step, each with the numbers of a single SampleStream.
class SampleStreams {
 public:
  Floats next_1d();
  Vec2s next_2d();
  Uints next_bits() { return mix(mix(key_, next_dimension()), sample_number_); }
  /// Skips `numbers` dimensions.
  void skip(std::uint32_t numbers) { dimension_ += numbers; }

 private:
  template <std::size_t capacity>
  friend class SampleStreamColumns;

  SampleStreams(const Uints& key, const Uints& sample_number, const Uints& dimension)
      : key_(key), sample_number_(sample_number), dimension_(dimension) {}
  Uints next_dimension() {
    const Uints next = dimension_;
    dimension_ += 1U;
    return next;
  }

  Uints key_, sample_number_, dimension_;
};

/// Columns of many streams.
template <std::size_t capacity>
class SampleStreamColumns {
 public:
  SampleStream at(std::size_t i) const {
    SampleStream stream;
    stream.key_ = key_[i];
    stream.sample_number_ = sample_number_[i];
    stream.dimension_ = dimension_[i];
    return stream;
  }
  void put(std::size_t i, const SampleStream& stream) {
    key_[i] = stream.key_;
    sample_number_[i] = stream.sample_number_;
    dimension_[i] = stream.dimension_;
  }
  SampleStreams load(std::size_t first) const {
    return {key_.load(first), sample_number_.load(first), dimension_.load(first)};
  }
  /// Stores the dimensions of streams that were loaded from here.
  void store(std::size_t first, const SampleStreams& streams) {
    dimension_.store(first, streams.dimension_);
  }
  void move(std::size_t first, const LanePacking& packing, std::size_t to) {
    key_.move(first, packing, to);
    sample_number_.move(first, packing, to);
    dimension_.move(first, packing, to);
  }

 private:
  UintColumn<capacity> key_, sample_number_, dimension_;
};

/// A small sequential generator with a stated algorithm (PCG-XSH-RR 64/32, O'Neill 2014). The
/// standard library's distributions differ between implementations; these do not.
class Pcg32 {
 public:
  explicit Pcg32(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint32_t next();
  /// Uniform in [0, bound), without modulo bias. bound > 0.
  std::uint32_t below(std::uint32_t bound);
  /// Uniform in [0, 1), with 53 bits.
  double uniform();
  /// Standard normal (Box and Muller 1958).
  double normal();
  /// Exponential with mean 1.
  double exponential();

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

/// Fisher-Yates shuffle with `generator`.
template <typename T>
void shuffle(std::span<T> items, Pcg32& generator) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[generator.below(static_cast<std::uint32_t>(i))]);
  }
}

}  // namespace foveola
