#include "renderer/base/numbers/random.h"

#include <array>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace foveola {
namespace {

// The published demo output of PCG's reference implementation for seed 42, stream 54.
TEST(Pcg32, FollowsTheReferenceImplementation) {
  Pcg32 generator(42, 54);
  const std::array<std::uint32_t, 6> expected = {0xa15c02b7, 0x7b47f409, 0xba1d3330,
                                                 0x83d2f293, 0xbfa4784b, 0xcbed606e};
  for (const std::uint32_t value : expected) {
    EXPECT_EQ(generator.next(), value);
  }
}

TEST(Pcg32, BelowIsUniform) {
  Pcg32 generator(1);
  std::array<int, 6> counts{};
  for (int i = 0; i < 60000; ++i) {
    ++counts[generator.below(6)];
  }
  double chi_squared = 0.0;
  for (const int count : counts) {
    chi_squared += (count - 10000.0) * (count - 10000.0) / 10000.0;
  }
  EXPECT_LT(chi_squared, 20.5);  // the 99.9 % quantile with 5 degrees of freedom
}

TEST(Pcg32, NormalHasUnitMoments) {
  Pcg32 generator(2);
  constexpr int count = 200000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = generator.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / count, 0.0, 5.0 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 1.0, 5.0 * std::sqrt(2.0 / count));
}

TEST(Shuffle, ReachesEveryOrderEquallyOften) {
  Pcg32 generator(3);
  std::array<int, 6> counts{};
  for (int i = 0; i < 60000; ++i) {
    std::array<int, 3> items = {0, 1, 2};
    shuffle(std::span<int>(items), generator);
    ++counts[static_cast<std::size_t>(items[0] * 2 + (items[1] > items[2] ? 1 : 0))];
  }
  double chi_squared = 0.0;
  for (const int count : counts) {
    chi_squared += (count - 10000.0) * (count - 10000.0) / 10000.0;
  }
  EXPECT_LT(chi_squared, 20.5);
}

// A (0, 2)-sequence puts one point in each elementary interval, whatever its shape.
TEST(Sobol2d, EveryAlignedRunIsANet) {
  for (const std::uint32_t seed : {0U, 1U, 0xdeadbeefU}) {
    for (const std::uint64_t start :
         {std::uint64_t{0}, std::uint64_t{256 * 1234567}, (std::uint64_t{1} << 32) * 3}) {
      for (unsigned log_width = 0; log_width <= 8; ++log_width) {
        const float width = static_cast<float>(1U << log_width);
        const float height = static_cast<float>(1U << (8 - log_width));
        std::set<std::pair<int, int>> boxes;
        for (std::uint64_t i = 0; i < 256; ++i) {
          const Vec2 p = sobol_2d(start + i, seed);
          boxes.insert({static_cast<int>(p.x * width), static_cast<int>(p.y * height)});
        }
        EXPECT_EQ(boxes.size(), 256U) << "seed " << seed << " start " << start;
      }
    }
  }
}

TEST(Sobol2d, StaysBelowOne) {
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const Vec2 p = sobol_2d(i, 7);
    EXPECT_TRUE(p.x >= 0.0F && p.x < 1.0F && p.y >= 0.0F && p.y < 1.0F);
  }
}

TEST(SampleStream, DependsOnEveryPartOfItsKey) {
  const float first = SampleStream(1, 2, 3).next_1d();
  EXPECT_EQ(first, SampleStream(1, 2, 3).next_1d());
  EXPECT_NE(first, SampleStream(2, 2, 3).next_1d());
  EXPECT_NE(first, SampleStream(1, 3, 3).next_1d());
  EXPECT_NE(first, SampleStream(1, 2, 4).next_1d());
}

TEST(SampleStreams, GiveWhatEachStreamGivesAlone) {
  std::vector<SampleStream> alone;
  SampleStreamColumns<16> columns;
  for (std::uint32_t i = 0; i < 16; ++i) {
    SampleStream stream(7, 1000 * i, 3 * i);
    for (std::uint32_t skipped = 0; skipped < i; ++skipped) {
      stream.next_bits();
    }
    columns.put(i, stream);
    alone.push_back(stream);
  }
  SampleStreams together = columns.load(8);
  const Floats numbers = together.next_1d();
  const Vec2s pairs = together.next_2d();
  const Uints bits = together.next_bits();
  together.skip(3);
  columns.store(8, together);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    SampleStream& stream = alone[8 + lane];
    EXPECT_EQ(numbers[lane], stream.next_1d());
    EXPECT_EQ(Vec2(pairs.x[lane], pairs.y[lane]), stream.next_2d());
    EXPECT_EQ(bits[lane], stream.next_bits());
    stream.next_1d();
    stream.next_2d();
    stream.next_bits();
    EXPECT_EQ(columns.at(8 + lane).next_1d(), stream.next_1d());
    EXPECT_EQ(columns.at(lane).next_1d(), alone[lane].next_1d()) << "others are as they were";
  }
}

// Whatever pixel and dimension: the scrambles keep the sequence's stratification.
TEST(SampleStream, EveryAlignedRunOfSampleNumbersIsANet) {
  for (const std::uint32_t start : {0U, 64U * 12345U}) {
    std::vector<SampleStream> streams;
    for (std::uint32_t i = 0; i < 64; ++i) {
      streams.emplace_back(3, 4711, start + i);
    }
    for (int dimension = 0; dimension < 20; ++dimension) {
      std::set<std::pair<int, int>> boxes;
      std::set<int> intervals;
      for (SampleStream& stream : streams) {
        const Vec2 p = stream.next_2d();
        boxes.insert({static_cast<int>(p.x * 8), static_cast<int>(p.y * 8)});
        intervals.insert(static_cast<int>(stream.next_1d() * 64));
      }
      EXPECT_EQ(boxes.size(), 64U);
      EXPECT_EQ(intervals.size(), 64U);
    }
  }
}

/// Of pairs (x, y) in an 8 x 8 grid; with 63 degrees of freedom the 99.9 % quantile is 103.4.
double chi_squared_of_pairs(const std::vector<Vec2>& pairs) {
  std::array<int, 64> counts{};
  for (const Vec2& pair : pairs) {
    ++counts[static_cast<std::size_t>(pair.x * 8) * 8 + static_cast<std::size_t>(pair.y * 8)];
  }
  const double expected = static_cast<double>(pairs.size()) / 64.0;
  double sum = 0.0;
  for (const int count : counts) {
    sum += (count - expected) * (count - expected) / expected;
  }
  return sum;
}

// Dimensions are padded: what one of them draws must say nothing about another, or about the
// neighbouring pixel.
TEST(SampleStream, DimensionsAndPixelsAreIndependent) {
  std::vector<Vec2> dimensions;
  std::vector<Vec2> neighbours;
  std::vector<Vec2> seeds;
  for (std::uint32_t pixel = 0; pixel < 20000; ++pixel) {
    SampleStream stream(1, pixel, 5);
    const float first = stream.next_1d();
    dimensions.emplace_back(first, stream.next_1d());
    neighbours.emplace_back(first, SampleStream(1, pixel + 1, 5).next_1d());
    seeds.emplace_back(first, SampleStream(2, pixel, 5).next_1d());
  }
  EXPECT_LT(chi_squared_of_pairs(dimensions), 110.0);
  EXPECT_LT(chi_squared_of_pairs(neighbours), 110.0);
  EXPECT_LT(chi_squared_of_pairs(seeds), 110.0);
}

}  // namespace
}  // namespace foveola
