#include "renderer/base/numbers/lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/turns.h"

namespace foveola {
namespace {

Vec3s random_vectors(Pcg32& random, Vec3Lanes& one_by_one) {
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    Vec3 v;
    for (int axis = 0; axis < 3; ++axis) {
      v[axis] = static_cast<float>(random.normal());
    }
    one_by_one.put(lane, v);
  }
  return one_by_one.load();
}

TEST(LanesTest, MasksVisitTheirLanesInOrder) {
  const Floats counted{0, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(bits_of(counted < 0.0F), 0U);
  EXPECT_EQ(bits_of(counted < 3.0F), 0b111U);
  EXPECT_EQ(bits_of(counted < 8.0F), 0xffU);
  const Floats numbers{5, -1, 7, 0, -3, 2, 9, -8};
  std::vector<std::size_t> visited;
  for_each_lane(numbers < 0.0F, [&](std::size_t lane) { visited.push_back(lane); });
  EXPECT_EQ(visited, (std::vector<std::size_t>{1, 4, 7}));
  EXPECT_TRUE(any_lane(numbers > 8.0F));
  EXPECT_FALSE(any_lane(numbers > 9.0F));
}

TEST(LanesTest, RowsBecomeColumns) {
  LaneRows rows;
  for (std::size_t row = 0; row < lane_count; ++row) {
    for (std::size_t column = 0; column < lane_count; ++column) {
      rows[row][column] = static_cast<float>(10 * row + column);
    }
  }
  const LaneRows columns = transposed(rows);
  for (std::size_t column = 0; column < lane_count; ++column) {
    for (std::size_t row = 0; row < lane_count; ++row) {
      EXPECT_EQ(columns[column][row], rows[row][column]);
    }
  }
}

TEST(LanesTest, MasksAndBitsSayTheSame) {
  for (std::uint32_t bits = 0; bits < 256; ++bits) {
    const LaneMask mask = mask_of(bits);
    EXPECT_EQ(bits_of(mask), bits);
    EXPECT_EQ(any_lane(mask), bits != 0);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      EXPECT_EQ(mask[lane], (bits >> lane & 1U) != 0 ? -1 : 0);
    }
  }
}

TEST(LanesTest, FunctionsAreThoseOfSingleNumbers) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const Floats x{0.25F, -2.5F, 3.5F, -0.0F, 1e30F, 1e-30F, 7.49F, infinity};
  const Floats sign{-1.0F, 1.0F, -0.0F, 0.0F, -3.0F, 4.0F, -infinity, 1.0F};
  for (std::size_t i = 0; i < lane_count; ++i) {
    EXPECT_EQ(magnitude(x)[i], std::abs(x[i]));
    EXPECT_EQ(with_sign(x, sign)[i], std::copysign(x[i], sign[i]));
    EXPECT_EQ(std::signbit(with_sign(x, sign)[i]), std::signbit(sign[i]));
    EXPECT_EQ(square_root(magnitude(x))[i], std::sqrt(std::abs(x[i])));
    EXPECT_EQ(nearest_integer(x)[i], std::nearbyint(x[i]));
    EXPECT_EQ(smaller(x, sign)[i], std::min(x[i], sign[i]));
    EXPECT_EQ(larger(x, 1.0F)[i], std::max(x[i], 1.0F));
    EXPECT_EQ(chosen(x > sign, x, sign)[i], x[i] > sign[i] ? x[i] : sign[i]);
  }
  EXPECT_EQ(truncated(x)[1], -2);
  EXPECT_EQ(truncated(x)[2], 3);
  const Ints whole{-5, 0, 3, 7, 8, 9, 100, -1};
  for (std::size_t i = 0; i < lane_count; ++i) {
    EXPECT_EQ(clamped(whole, 7)[i], std::clamp(whole[i], 0, 7));
    EXPECT_EQ(clamped(whole[i], 7), std::clamp(whole[i], 0, 7));
    EXPECT_EQ(floats_of(whole)[i], floats_of(whole[i]));
  }
}

TEST(LanesTest, VectorsAreThoseOfGlm) {
  Pcg32 random(1);
  Vec3Lanes a;
  Vec3Lanes b;
  const Vec3s as = random_vectors(random, a);
  const Vec3s bs = random_vectors(random, b);
  Vec3Lanes across;
  Vec3Lanes unit;
  across.store(cross(as, bs));
  unit.store(normalized(as));
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    EXPECT_EQ(dot(as, bs)[lane], glm::dot(a.at(lane), b.at(lane)));
    EXPECT_EQ(across.at(lane), glm::cross(a.at(lane), b.at(lane)));
    EXPECT_EQ(unit.at(lane), glm::normalize(a.at(lane)));
    EXPECT_EQ(max_component(as)[lane], max_component(a.at(lane)));
    EXPECT_EQ(luminance(as)[lane], luminance(a.at(lane)));
  }
}

TEST(LanesTest, WhatIsNotFiniteIsFound) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Floats odd{1.0F, infinity, -infinity, nan, -nan, 3e38F, 0.0F, -1e-45F};
  const Floats even = all_lanes(2.0F);
  for (const Vec3s& v : {Vec3s{odd, even, even}, Vec3s{even, odd, even}, Vec3s{even, even, odd}}) {
    EXPECT_EQ(bits_of(is_finite(v)), 0b11100001U);
  }
}

TEST(LanesTest, FramesAreOrthonormalAndRightHanded) {
  Pcg32 random(2);
  for (int i = 0; i < 100; ++i) {
    Vec3Lanes vectors;
    const Vec3s normals = normalized(random_vectors(random, vectors));
    const Frames frames(normals);
    const Vec3s third = cross(frames.tangent, frames.bitangent);
    const Vec3s local = frames.to_local(frames.to_world(vectors.load()));
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      EXPECT_NEAR(dot(frames.tangent, frames.tangent)[lane], 1.0F, 1e-6F);
      EXPECT_NEAR(dot(frames.tangent, frames.bitangent)[lane], 0.0F, 1e-6F);
      EXPECT_NEAR(dot(third, normals)[lane], 1.0F, 1e-6F);
      EXPECT_NEAR(local.x[lane], vectors.x[lane], 3e-6F);
    }
  }
}

TEST(LanesTest, SinesAndCosinesAreThoseOfTheAngles) {
  for (int i = 0; i < 1000; ++i) {
    Floats turns;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      turns[lane] = static_cast<float>(8 * i + static_cast<int>(lane)) / 4000.0F - 1.0F;
    }
    const SinesCosines<Floats> both = sine_cosine_of_turns(turns);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const double angle = 2.0 * std::numbers::pi * turns[lane];
      EXPECT_NEAR(both.sine[lane], std::sin(angle), 1e-7);
      EXPECT_NEAR(both.cosine[lane], std::cos(angle), 1e-7);
    }
  }
}

}  // namespace
}  // namespace foveola
