#include "renderer/trace/lights/suns.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "tests/renderer/trace/random_points.h"
#include "tests/renderer/trace/statistics.h"
#include "tests/renderer/view/chi_squared.h"

namespace foveola {
namespace {

using std::numbers::pi;
using test::unit_square;

PunctualLight sun(float irradiance, const Vec3& towards, float angular_radius_rad) {
  return {.kind = PunctualLight::Kind::directional,
          .direction = -glm::normalize(towards),
          .intensity = Rgb(irradiance),
          .angular_radius_rad = angular_radius_rad};
}

Suns suns_of(const std::vector<PunctualLight>& lights) {
  Scene scene;
  scene.lights = lights;
  return Suns(scene);
}

TEST(SunsTest, WithoutASizeItIsOneDirection) {
  const Suns suns = suns_of({sun(3.0F, {1, 2, 0}, 0.0F)});
  const Suns::Sample sample = suns.sample(Vec2(0.5F), Vec2(0.5F));
  EXPECT_TRUE(sample.is_delta);
  EXPECT_NEAR(glm::length(sample.direction - glm::normalize(Vec3(1, 2, 0))), 0.0, 1e-6);
  EXPECT_EQ(sample.irradiance, Rgb(3.0F));
  EXPECT_EQ(sample.probability, 1.0F);
  EXPECT_EQ(suns.at(sample.direction).radiance, Rgb(0.0F));
  EXPECT_EQ(suns.at(sample.direction).pdf, 0.0F);
}

TEST(SunsTest, DiscGivesItsIrradianceAcrossItsDirection) {
  for (const float radius : {1e-3F, 4.65e-3F, 0.2F, 1.5F, 3.0F}) {
    const Vec3 towards = glm::normalize(Vec3(1, 2, -0.5F));
    const Suns suns = suns_of({sun(3.0F, towards, radius)});
    MeanEstimate irradiance;
    Pcg32 random(1);
    for (int i = 0; i < 20000; ++i) {
      const Vec2 choice = unit_square(random);
      const Suns::Sample sample = suns.sample(choice, unit_square(random));
      ASSERT_FALSE(sample.is_delta);
      irradiance.add(suns.at(sample.direction, sample.sun).radiance.g *
                     glm::dot(sample.direction, towards) /
                     suns.at(sample.direction, sample.sun).pdf);
    }
    expect_mean(irradiance, 3.0, 1e-4);
  }
}

TEST(SunsTest, RaysSeeTheDisc) {
  const Suns suns = suns_of({sun(2.0F, {0, 1, 0}, 0.01F)});
  const double radiance = 2.0 / (pi * std::sin(0.01) * std::sin(0.01));
  const auto at = [](double angle) { return Vec3(std::sin(angle), std::cos(angle), 0.0); };
  EXPECT_NEAR(suns.at(at(0.0)).radiance.g, radiance, 1e-4 * radiance);
  EXPECT_NEAR(suns.at(at(0.00999)).radiance.g, radiance, 1e-4 * radiance);
  EXPECT_EQ(suns.at(at(0.01001)).radiance.g, 0.0F);
  EXPECT_EQ(suns.at(at(pi)).radiance.g, 0.0F);
}

TEST(SunsTest, OverlappingDiscsAreDrawnByTheirDensity) {
  const Suns suns = suns_of({sun(2.0F, {0, 1, 0}, 0.4F), sun(5.0F, {0.5F, 1, 0}, 0.3F)});
  const Vec3 pole = glm::normalize(Vec3(0.2F, 1, 0));
  std::vector<Vec3> directions;
  Pcg32 random(2);
  for (int i = 0; i < 50000; ++i) {
    const Vec2 choice = unit_square(random);
    directions.push_back(suns.sample(choice, unit_square(random)).direction);
  }
  const auto density = [&](const Vec3& w) { return static_cast<double>(suns.at(w).pdf); };
  EXPECT_NEAR(test::integral_over_sphere(density, pole), 1.0, 1e-3);
  EXPECT_GT(test::chi_squared_p_value(directions, density, pole), sidak_level(1));
  EXPECT_NEAR(suns.irradiance(), 7.0, 1e-5);
}

TEST(SunsTest, BrokenAndBlackOnesAreLeftOut) {
  PunctualLight point = sun(1.0F, {0, 1, 0}, 0.1F);
  point.kind = PunctualLight::Kind::point;
  PunctualLight aimless = sun(1.0F, {0, 1, 0}, 0.1F);
  aimless.direction = Vec3(0.0F);
  EXPECT_TRUE(
      suns_of({point, aimless, sun(0.0F, {0, 1, 0}, 0.1F), sun(NAN, {0, 1, 0}, 0.1F)}).empty());
}

TEST(SunsTest, BrokenRadiiAreNone) {
  for (const float radius : {-1.0F, NAN, 1e-6F}) {
    EXPECT_TRUE(suns_of({sun(1.0F, {0, 1, 0}, radius)}).sample(Vec2(0.5F), Vec2(0.5F)).is_delta);
  }
}

}  // namespace
}  // namespace foveola
