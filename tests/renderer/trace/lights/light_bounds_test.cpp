#include "renderer/trace/lights/light_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "tests/renderer/trace/random_points.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

using std::numbers::pi;
using test::in_cube;

LightBounds random_bounds(Pcg32& random) {
  const Vec3 lower = in_cube(random);
  const Vec3 size = 0.5F * (in_cube(random) + 1.0F);
  const double spread = pi * random.uniform() * random.uniform() * random.uniform();
  return {.box = {.lower = lower, .upper = lower + size},
          .axis = glm::normalize(DVec3(in_cube(random))),
          .spread_rad = spread,
          .falloff_rad = 0.5 * pi * random.uniform(),
          .two_sided = random.uniform() < 0.3,
          .intensity = random.uniform() + 0.1};
}

/// A direction in the bounds' cone, on its rim as often as not.
Vec3 direction_in(const LightBounds& bounds, Pcg32& random) {
  const double half = std::sin(0.5 * bounds.spread_rad);
  const DirectionCone cone{Vec3(bounds.axis), static_cast<float>(2.0 * half * half)};
  const float y = unit_float(random.next());
  return cone.sample({random.uniform() < 0.5 ? 1.0F : unit_float(random.next()), y}).direction;
}

double angle_beyond(const LightBounds& bounds, const Vec3& direction) {
  const double angle = angle_between(Vec3(bounds.axis), direction);
  return (bounds.two_sided ? std::min(angle, pi - angle) : angle) - bounds.spread_rad;
}

TEST(LightBoundsTest, MergedBoundsHoldBoth) {
  Pcg32 random(1);
  for (int i = 0; i < 1000; ++i) {
    const LightBounds a = random_bounds(random);
    const LightBounds b = random_bounds(random);
    const LightBounds both = merge(a, b);
    EXPECT_DOUBLE_EQ(both.intensity, a.intensity + b.intensity);
    for (const LightBounds& one : {a, b}) {
      EXPECT_EQ(glm::min(both.box.lower, one.box.lower), both.box.lower);
      EXPECT_EQ(glm::max(both.box.upper, one.box.upper), both.box.upper);
      EXPECT_GE(both.falloff_rad, one.falloff_rad);
      EXPECT_TRUE(both.two_sided || !one.two_sided);
      for (int k = 0; k < 20; ++k) {
        EXPECT_LT(angle_beyond(both, direction_in(one, random)), 1e-5);
      }
    }
  }
}

TEST(LightBoundsTest, MergedConesAreNoWiderThanNeeded) {
  LightBounds a{.axis = {1, 0, 0}, .spread_rad = 0.1, .intensity = 1.0};
  LightBounds b{.axis = {0, 1, 0}, .spread_rad = 0.2, .intensity = 1.0};
  EXPECT_NEAR(merge(a, b).spread_rad, 0.5 * (0.5 * pi + 0.3), 1e-12);
  b.axis = {std::cos(0.05), std::sin(0.05), 0.0};
  EXPECT_DOUBLE_EQ(merge(a, b).spread_rad, 0.2);
  EXPECT_DOUBLE_EQ(merge(b, a).spread_rad, 0.2);
  // The two ends of one line.
  a.two_sided = b.two_sided = true;
  b.axis = {-1, 0, 0};
  EXPECT_DOUBLE_EQ(merge(a, b).spread_rad, 0.2);
}

TEST(LightBoundsTest, NothingAddsNothing) {
  Pcg32 random(2);
  const LightBounds a = random_bounds(random);
  EXPECT_DOUBLE_EQ(merge(a, {}).spread_rad, a.spread_rad);
  EXPECT_EQ(merge({}, a).box.lower, a.box.lower);
}

TEST(LightBoundsTest, OrientationMeasureIsItsIntegral) {
  for (const double spread : {0.0, 0.3, 1.5, 3.0}) {
    for (const double falloff : {0.1, 0.5 * pi}) {
      constexpr int steps = 20000;
      double sum = 0.0;
      for (int i = 0; i < steps; ++i) {
        const double angle = pi * (i + 0.5) / steps;
        const double beyond = std::max(0.0, angle - spread);
        sum += beyond < falloff ? std::cos(beyond) * std::sin(angle) : 0.0;
      }
      const LightBounds bounds{.spread_rad = spread, .falloff_rad = falloff, .intensity = 1.0};
      EXPECT_NEAR(orientation_measure(bounds), 2.0 * pi * sum * pi / steps, 2e-3);
    }
  }
}

using std::numbers::pi;

TEST(DirectionConeTest, SolidAngleIsThatOfTheCap) {
  for (const double angle : {1e-4, 4.65e-3, 0.3, 1.5}) {
    const double sine = std::sin(angle);
    const auto cone = DirectionCone::with_sine_squared({0, 1, 0}, static_cast<float>(sine * sine));
    const double half = std::sin(angle / 2.0);
    EXPECT_NEAR(cone.solid_angle() / (4.0 * pi * half * half), 1.0, 1e-5);
  }
}

/// Bins of equal solid angle: in the height below the cap's top and around the axis.
TEST(DirectionConeTest, DirectionsAreUniform) {
  const Vec3 axis = glm::normalize(Vec3(0.3F, -0.8F, 0.4F));
  for (const float one_minus_cosine : {1.1e-5F, 0.2F, 1.0F, 2.0F}) {
    const DirectionCone cone{axis, one_minus_cosine};
    constexpr int draws = 40000;
    constexpr int heights = 20;
    constexpr int sectors = 20;
    std::vector<double> observed(heights * sectors, 0.0);
    Pcg32 random(2);
    for (int i = 0; i < draws; ++i) {
      const float x = unit_float(random.next());
      const float y = unit_float(random.next());
      const auto sample = cone.sample({x, y});
      const DVec3 chord = DVec3(sample.direction) - DVec3(axis);
      const double share = 0.5 * glm::dot(chord, chord) / one_minus_cosine;
      const Vec3 local = Frame(axis).to_local(sample.direction);
      const double turn = std::atan2(local.y, local.x) / (2.0 * pi) + 0.5;
      const int height = std::clamp(static_cast<int>(share * heights), 0, heights - 1);
      const int sector = std::clamp(static_cast<int>(turn * sectors), 0, sectors - 1);
      observed[static_cast<std::size_t>(height * sectors + sector)] += 1.0;
      EXPECT_NEAR(glm::length(sample.direction), 1.0, 1e-6);
      EXPECT_NEAR(sample.cosine, glm::dot(sample.direction, axis), 1e-6);
      EXPECT_NEAR(sample.sine_squared, 1.0F - sample.cosine * sample.cosine, 1e-6);
    }
    const std::vector<double> expected(heights * sectors,
                                       static_cast<double>(draws) / (heights * sectors));
    EXPECT_GT(chi_squared_p_value(observed, expected), sidak_level(4));
  }
}

}  // namespace

}  // namespace foveola
