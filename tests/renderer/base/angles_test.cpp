#include "renderer/base/angles.h"

#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

using std::numbers::pi;

TEST(Angles, FollowTheWorldConvention) {
  const auto near = [](const Vec3& a, const Vec3& b) { return glm::distance(a, b) < 1e-6F; };
  EXPECT_TRUE(near(direction_from({.azimuth_rad = 0.0, .elevation_rad = 0.0}), {0, 0, -1}));
  EXPECT_TRUE(near(direction_from({.azimuth_rad = pi / 2, .elevation_rad = 0.0}), {1, 0, 0}));
  EXPECT_TRUE(near(direction_from({.azimuth_rad = pi, .elevation_rad = 0.0}), {0, 0, 1}));
  EXPECT_TRUE(near(direction_from({.azimuth_rad = 0.3, .elevation_rad = pi / 2}), {0, 1, 0}));
}

TEST(Angles, RoundTrip) {
  Pcg32 generator(1);
  for (int i = 0; i < 1000; ++i) {
    const double azimuth_rad = (generator.uniform() - 0.5) * 2.0 * pi;
    const double elevation_rad = (generator.uniform() - 0.5) * (pi - 1e-3);
    const AzimuthElevation back = azimuth_elevation(
        3.0F * direction_from({.azimuth_rad = azimuth_rad, .elevation_rad = elevation_rad}));
    EXPECT_NEAR(back.azimuth_rad, azimuth_rad, 1e-3);
    EXPECT_NEAR(back.elevation_rad, elevation_rad, 1e-6);
  }
}

TEST(Angles, AreAccurateForNearlyEqualAndNearlyOppositeDirections) {
  const Vec3 forward(0.0F, 0.0F, -1.0F);
  const Vec3 beside(1e-5F, 0.0F, -1.0F);
  EXPECT_NEAR(angle_between(forward, beside), 1e-5, 1e-10);
  EXPECT_NEAR(angle_between(forward, -beside), pi - 1e-5, 1e-10);
  EXPECT_DOUBLE_EQ(angle_between(forward, forward), 0.0);
  EXPECT_NEAR(angle_between(forward, {0.0F, 2.0F, 0.0F}), pi / 2, 1e-12);
}

TEST(Frame, IsRightHandedAndOrthonormalForEveryNormal) {
  Pcg32 generator(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 normal = glm::normalize(
        i == 0 ? Vec3(0, 0, -1) : Vec3(generator.normal(), generator.normal(), generator.normal()));
    const Frame frame(normal);
    EXPECT_NEAR(glm::dot(frame.tangent, frame.normal), 0.0F, 1e-6F);
    EXPECT_NEAR(glm::length(frame.tangent), 1.0F, 1e-6F);
    EXPECT_LT(glm::distance(glm::cross(frame.tangent, frame.bitangent), frame.normal), 1e-5F);
    const Vec3 world(0.3F, -0.5F, 0.7F);
    EXPECT_LT(glm::distance(frame.to_world(frame.to_local(world)), world), 1e-6F);
  }
}

}  // namespace
}  // namespace foveola
