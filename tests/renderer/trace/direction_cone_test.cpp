#include "renderer/trace/direction_cone.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/random.h"
#include "statistics.h"

namespace foveola {
namespace {

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
