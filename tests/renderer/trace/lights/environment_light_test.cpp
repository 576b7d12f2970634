#include "renderer/trace/lights/environment_light.h"

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
using test::unit_square;

Environment map_of(int width, int height, const Rgb& background) {
  Environment environment;
  environment.map_width = width;
  environment.map_height = height;
  environment.map.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                         background);
  return environment;
}

/// A dim sky with a bright spot beside the seam, a brighter one at a pole, and black texels.
Environment uneven_map() {
  Environment environment = map_of(16, 8, Rgb(0.2F));
  environment.map[3 * 16 + 15] = Rgb(40.0F, 20.0F, 5.0F);
  environment.map[3] = Rgb(90.0F);
  for (std::size_t x = 4; x < 9; ++x) {
    environment.map[5 * 16 + x] = Rgb(0.0F);
    environment.map[6 * 16 + x] = Rgb(0.0F);
  }
  return environment;
}

/// The direction of the centre of a texel, by the film's convention.
Vec3 centre_of_texel(const Environment& environment, int x, int y) {
  return direction_from({.azimuth_rad = ((x + 0.5) / environment.map_width - 0.5) * 2.0 * pi,
                         .elevation_rad = (0.5 - (y + 0.5) / environment.map_height) * pi});
}

TEST(EnvironmentLightTest, TexelCentresHaveTheirTexelsRadiance) {
  Environment environment = map_of(8, 4, Rgb(0.0F));
  for (std::size_t i = 0; i < environment.map.size(); ++i) {
    environment.map[i] = Rgb(static_cast<float>(i), 1.0F, 2.0F);
  }
  environment.radiance = Rgb(0.5F, 1.0F, 3.0F);
  const EnvironmentLight light(environment);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      const Rgb radiance = light.at(centre_of_texel(environment, x, y)).radiance;
      EXPECT_NEAR(radiance.r, 0.5 * (8 * y + x), 1e-3) << x << ' ' << y;
      EXPECT_NEAR(radiance.b, 6.0, 1e-4);
    }
  }
}

TEST(EnvironmentLightTest, CentreOfTheImageIsMinusZAndItsRightIsPlusX) {
  Environment environment = map_of(4, 2, Rgb(0.0F));
  environment.map[2] = environment.map[6] = Rgb(1.0F);  // the column right of the centre
  const EnvironmentLight light(environment);
  EXPECT_GT(light.at(glm::normalize(Vec3(1, 0, -1))).radiance.r, 0.99F);
  EXPECT_LT(light.at(glm::normalize(Vec3(-1, 0, -1))).radiance.r, 0.01F);
  EXPECT_NEAR(light.at(Vec3(0, 0, -1)).radiance.r, 0.5, 1e-5);
}

TEST(EnvironmentLightTest, IsContinuousAcrossTheSeam) {
  const Environment environment = uneven_map();
  const EnvironmentLight light(environment);
  for (const float y : {-0.5F, 0.1F, 0.4F}) {
    const Rgb left = light.at(glm::normalize(Vec3(-1e-6F, y, 1.0F))).radiance;
    const Rgb right = light.at(glm::normalize(Vec3(1e-6F, y, 1.0F))).radiance;
    EXPECT_NEAR(left.r, right.r, 1e-3F * (1.0F + left.r));
  }
}

TEST(EnvironmentLightTest, PolesAreFinite) {
  const Environment environment = uneven_map();
  const EnvironmentLight light(environment);
  for (const float y : {1.0F, -1.0F}) {
    EXPECT_TRUE(is_finite(light.at(Vec3(0, y, 0)).radiance));
    EXPECT_GT(light.at(Vec3(0, y, 0)).pdf, 0.0F);
  }
}

struct DirectionHistograms {
  std::vector<double> observed;
  std::vector<double> expected;
  double integral = 0.0;  ///< the density's integral over all directions
};

DirectionHistograms histograms_of(const EnvironmentLight& light, int draws) {
  constexpr int rings = 20;
  constexpr int sectors = 36;
  constexpr int points = 16;
  DirectionHistograms h{std::vector<double>(rings * sectors), std::vector<double>(rings * sectors)};
  Pcg32 random(5);
  for (int i = 0; i < draws; ++i) {
    const Vec3 w = light.sample(unit_square(random)).direction;
    const int ring = std::min(rings - 1, static_cast<int>((0.5 - 0.5 * w.y) * rings));
    const int sector = std::min(
        sectors - 1, static_cast<int>((std::atan2(w.x, -w.z) / (2.0 * pi) + 0.5) * sectors));
    h.observed[static_cast<std::size_t>(ring * sectors + sector)] += 1.0;
  }
  const double solid_angle = 4.0 * pi / (rings * points * sectors * points);
  for (int i = 0; i < rings * points; ++i) {
    const double y = 1.0 - 2.0 * (i + 0.5) / (rings * points);
    const double horizontal = std::sqrt(1.0 - y * y);
    for (int k = 0; k < sectors * points; ++k) {
      const double azimuth = ((k + 0.5) / (sectors * points) - 0.5) * 2.0 * pi;
      const Vec3 w(horizontal * std::sin(azimuth), y, -horizontal * std::cos(azimuth));
      const double probability = light.at(w).pdf * solid_angle;
      h.expected[static_cast<std::size_t>(i / points * sectors + k / points)] +=
          draws * probability;
      h.integral += probability;
    }
  }
  return h;
}

TEST(EnvironmentLightTest, MapIsSampledByItsDensity) {
  const Environment environment = uneven_map();
  const DirectionHistograms h = histograms_of(EnvironmentLight(environment), 100000);
  EXPECT_NEAR(h.integral, 1.0, 2e-3);
  EXPECT_GT(chi_squared_p_value(h.observed, h.expected), 1e-3);
}

TEST(EnvironmentLightTest, ConstantIsSampledUniformly) {
  Environment environment;
  const DirectionHistograms h = histograms_of(EnvironmentLight(environment), 100000);
  EXPECT_NEAR(h.integral, 1.0, 1e-5);
  EXPECT_GT(chi_squared_p_value(h.observed, h.expected), 1e-3);
}

TEST(EnvironmentLightTest, SamplesCarryTheLightOfTheirDirection) {
  const Environment environment = uneven_map();
  const EnvironmentLight light(environment);
  Pcg32 random(6);
  int differing = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto sample = light.sample(unit_square(random));
    const DistantLight asked = light.at(sample.direction);
    differing += std::abs(asked.pdf - sample.light.pdf) > 1e-3F * sample.light.pdf ? 1 : 0;
    EXPECT_NEAR(asked.radiance.g, sample.light.radiance.g, 2e-3F);
  }
  EXPECT_LT(differing, 10);  // rounding across a cell's border
}

/// Radiance sin(elevation) above the horizon: the irradiance on a floor is the integral of
/// sin^2 * cos * 2 pi over elevations from 0 to pi/2, which is 2 pi / 3.
/// But next to the borders of cells, and near the poles, where a direction says little of where it
/// comes from.
void expect_places_found_again(const Environment& environment) {
  const EnvironmentLight light(environment);
  Pcg32 random(12);
  int found = 0;
  constexpr int draws = 5000;
  for (int i = 0; i < draws; ++i) {
    const Vec2 u = unit_square(random);
    const Vec2 place = light.place_of(light.sample(u).direction);
    EXPECT_GE(glm::min(place.x, place.y), 0.0F);
    EXPECT_LE(glm::max(place.x, place.y), 1.0F);
    found += glm::distance(place, u) < 1e-3F ? 1 : 0;
  }
  EXPECT_GT(found, 0.99 * draws);
}

TEST(EnvironmentLightTest, PlacesOfDirectionsAreTheNumbersThatDrawThem) {
  expect_places_found_again(map_of(0, 0, Rgb(0.0F)));
  Environment map = uneven_map();
  expect_places_found_again(map);
  map.rotation_rad = 1.3;
  expect_places_found_again(map);
}

TEST(EnvironmentLightTest, IrradianceOfAKnownMap) {
  constexpr int height = 256;
  Environment environment = map_of(512, height, Rgb(0.0F));
  for (int y = 0; y < height; ++y) {
    const double elevation = (0.5 - (y + 0.5) / height) * pi;
    for (std::size_t x = 0; x < 512; ++x) {
      environment.map[static_cast<std::size_t>(y) * 512 + x] =
          Rgb(static_cast<float>(std::max(0.0, std::sin(elevation))));
    }
  }
  const EnvironmentLight light(environment);
  MeanEstimate irradiance;
  Pcg32 random(8);
  for (int i = 0; i < 50000; ++i) {
    const auto sample = light.sample(unit_square(random));
    irradiance.add(light.at(sample.direction).radiance.r * std::max(0.0F, sample.direction.y) /
                   sample.light.pdf);
  }
  expect_mean(irradiance, 2.0 * pi / 3.0, 1e-4, 0.005);
  EXPECT_NEAR(light.total_luminance(), pi, 1e-3);
  environment.radiance = Rgb(3.0F);
  EXPECT_NEAR(EnvironmentLight(environment).total_luminance(), 3.0 * pi, 3e-3);
}

TEST(EnvironmentLightTest, RotationMovesTheMapTowardsPlusX) {
  Environment environment = uneven_map();
  const EnvironmentLight straight(environment);
  for (const double rotation : {0.5 * pi, 2.0, -3.0, 40.0}) {
    Environment turned = environment;
    turned.rotation_rad = rotation;
    const EnvironmentLight light(turned);
    for (const double azimuth : {-3.1, -1.0, 0.0, 0.7, 3.1}) {
      const Vec3 here = direction_from({.azimuth_rad = azimuth, .elevation_rad = 0.4});
      const Vec3 there = direction_from({.azimuth_rad = azimuth + rotation, .elevation_rad = 0.4});
      EXPECT_NEAR(light.at(there).radiance.r, straight.at(here).radiance.r, 2e-4);
    }
  }
  // A quarter turn brings the image's centre from -Z to +X.
  environment = map_of(4, 2, Rgb(0.0F));
  environment.map[1] = environment.map[2] = Rgb(1.0F);
  environment.rotation_rad = 0.5 * pi;
  EXPECT_GT(EnvironmentLight(environment).at(glm::normalize(Vec3(1, 1, 0))).radiance.r, 0.99F);
}

TEST(EnvironmentLightTest, RotatedMapIsSampledByItsDensity) {
  constexpr int rotations = 3;
  for (const double rotation : {0.3, pi, -2.2}) {
    Environment environment = uneven_map();
    environment.rotation_rad = rotation;
    const EnvironmentLight light(environment);
    const DirectionHistograms h = histograms_of(light, 100000);
    EXPECT_NEAR(h.integral, 1.0, 3e-3);
    EXPECT_GT(chi_squared_p_value(h.observed, h.expected), sidak_level(rotations));
    Pcg32 random(7);
    int differing = 0;
    for (int i = 0; i < 10000; ++i) {
      const auto sample = light.sample(unit_square(random));
      const float pdf = light.at(sample.direction).pdf;
      differing += std::abs(pdf - sample.light.pdf) > 1e-3F * sample.light.pdf ? 1 : 0;
    }
    EXPECT_LT(differing, 10);
  }
}

TEST(EnvironmentLightTest, EveryNumberGivesAFiniteDirection) {
  constexpr float largest = 1.0F - 0x1p-24F;
  Environment environment = uneven_map();
  environment.rotation_rad = 1.0;
  for (const Environment& each : {environment, Environment()}) {
    const EnvironmentLight light(each);
    for (const Vec2& u : {Vec2(0.0F), Vec2(largest), Vec2(0.0F, largest), Vec2(largest, 0.0F)}) {
      const auto sample = light.sample(u);
      EXPECT_NEAR(glm::length(sample.direction), 1.0, 1e-5);
      EXPECT_GT(sample.light.pdf, 0.0F);
      EXPECT_TRUE(is_finite(light.at(sample.direction).radiance));
    }
  }
}

TEST(EnvironmentLightTest, BrokenTexelsAreNotDrawn) {
  Environment environment = map_of(4, 4, Rgb(1.0F));
  environment.map[5] = Rgb(std::nanf(""));
  environment.map[10] = Rgb(INFINITY);
  const EnvironmentLight light(environment);
  EXPECT_TRUE(std::isfinite(light.total_luminance()));
  Pcg32 random(9);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_TRUE(is_finite(light.at(light.sample(unit_square(random)).direction).radiance));
  }
}

}  // namespace
}  // namespace foveola
