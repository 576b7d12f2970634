#include "renderer/trace/lights/punctual_lights.h"

#include <cmath>
#include <limits>
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

PunctualLights lights_of(const PunctualLight& light) {
  Scene scene;
  scene.lights = {light};
  return PunctualLights(scene);
}

PunctualLight point(float intensity, float radius_m = 0.0F) {
  return {.position = Vec3(0, 2, 0), .intensity = Rgb(intensity), .radius_m = radius_m};
}

PunctualLight spot(float inner_rad, float outer_rad, float radius_m = 0.0F) {
  PunctualLight light = point(5.0F, radius_m);
  light.kind = PunctualLight::Kind::spot;
  light.direction = Vec3(0, -1, 0);
  light.inner_cone_rad = inner_rad;
  light.outer_cone_rad = outer_rad;
  return light;
}

/// On a surface at `place` with the given normal.
MeanEstimate irradiance(const PunctualLights& lights, const Vec3& place, const Vec3& normal,
                        int samples) {
  MeanEstimate estimate;
  Pcg32 random(1);
  for (int i = 0; i < samples; ++i) {
    const auto sample = lights.sample(0, place, unit_square(random));
    estimate.add(sample ? sample->radiance.g *
                              std::max(0.0F, glm::dot(glm::normalize(sample->to_light), normal)) /
                              sample->pdf
                        : 0.0);
  }
  return estimate;
}

TEST(PunctualLightsTest, PointFallsOffWithTheSquaredDistance) {
  const auto sample = lights_of(point(12.0F)).sample(0, Vec3(0, -1, 4), Vec2(0.5F));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->is_delta);
  EXPECT_EQ(sample->to_light, Vec3(0, 3, -4));
  EXPECT_FLOAT_EQ(sample->radiance.g, 12.0F / 25.0F);
  EXPECT_EQ(sample->pdf, 1.0F);
}

/// KHR_lights_punctual, "Inner and outer cone angles", to the letter.
double attenuation(double inner, double outer, double angle) {
  const double scale = 1.0 / std::max(0.001, std::cos(inner) - std::cos(outer));
  const double offset = -std::cos(outer) * scale;
  const double value = std::clamp(std::cos(angle) * scale + offset, 0.0, 1.0);
  return value * value;
}

TEST(PunctualLightsTest, SpotHasTheExtensionsCone) {
  for (const auto& [inner, outer] : {std::pair(0.0F, 0.7853982F), std::pair(0.3F, 0.5F),
                                     std::pair(0.4F, 0.4001F), std::pair(0.0F, 1.57F)}) {
    const PunctualLights lights = lights_of(spot(inner, outer));
    for (const double angle : {0.0, 0.2, 0.35, 0.3999, 0.45, 0.7, 1.2, 2.0, pi}) {
      const Vec3 place(std::sin(angle), 2.0 - std::cos(angle), 0.0);
      const auto sample = lights.sample(0, place, Vec2(0.5F));
      EXPECT_NEAR(sample ? sample->radiance.g : 0.0, 5.0 * attenuation(inner, outer, angle), 2e-3);
    }
  }
}

/// Cycles's kernel/light/spot.h, with the cosine that it had in Blender 3.4.
double attenuation_in_cycles(double inner, double outer, double angle) {
  const double rim = std::cos(inner) - std::cos(outer);
  const double t = std::clamp((std::cos(angle) - std::cos(outer)) / rim, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t) * std::cos(angle);
}

TEST(PunctualLightsTest, SpotHasTheConeOfCyclesIfItSaysSo) {
  PunctualLight light = spot(0.3F, 0.7F);
  for (const double angle : {0.0, 0.2, 0.35, 0.5, 0.65, 0.75, 2.0}) {
    const Vec3 place(std::sin(angle), 2.0 - std::cos(angle), 0.0);
    const double expected = 5.0 * attenuation_in_cycles(0.3F, 0.7F, angle);
    light.cone_edge = PunctualLight::ConeEdge::smooth_times_cosine;
    const auto with_cosine = lights_of(light).sample(0, place, Vec2(0.5F));
    EXPECT_NEAR(with_cosine ? with_cosine->radiance.g : 0.0, expected, 1e-4);
    light.cone_edge = PunctualLight::ConeEdge::smooth;
    const auto without = lights_of(light).sample(0, place, Vec2(0.5F));
    EXPECT_NEAR(without ? without->radiance.g : 0.0, expected / std::cos(angle), 1e-4);
  }
}

/// The integral of a spot's intensity over all directions, by the midpoint rule.
template <typename Attenuation>
double integral_of(const Attenuation& attenuation, double inner, double outer) {
  constexpr int steps = 10000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double angle = pi * (i + 0.5) / steps;
    sum += 5.0 * attenuation(inner, outer, angle) * 2.0 * pi * std::sin(angle) * pi / steps;
  }
  return sum;
}

TEST(PunctualLightsTest, PowerIsTheIntegralOfTheIntensity) {
  EXPECT_NEAR(lights_of(point(3.0F)).power(0), 12.0 * pi, 1e-5);
  for (const auto& [inner, outer] :
       {std::pair(0.0F, 0.7853982F), std::pair(0.3F, 0.5F), std::pair(0.0F, 1.57F)}) {
    PunctualLight light = spot(inner, outer);
    const double sum = integral_of(attenuation, inner, outer);
    EXPECT_NEAR(lights_of(light).power(0), sum, 1e-4 * sum);
    light.cone_edge = PunctualLight::ConeEdge::smooth_times_cosine;
    const double with_cosine = integral_of(attenuation_in_cycles, inner, outer);
    EXPECT_NEAR(lights_of(light).power(0), with_cosine, 1e-4 * with_cosine);
    light.cone_edge = PunctualLight::ConeEdge::smooth;
    const double smooth = integral_of(
        [](double inner_rad, double outer_rad, double angle) {
          return std::cos(angle) > 0.0
                     ? attenuation_in_cycles(inner_rad, outer_rad, angle) / std::cos(angle)
                     : 0.0;
        },
        inner, outer);
    EXPECT_NEAR(lights_of(light).power(0), smooth, 1e-4 * smooth);
  }
}

/// A sphere wholly above a surface's horizon gives it what a point of the same intensity would.
TEST(PunctualLightsTest, SphereGivesTheIrradianceOfAPoint) {
  const Vec3 place(1, -1, 0.5F);
  const Vec3 to_centre = Vec3(0, 2, 0) - place;
  const double squared = glm::dot(to_centre, to_centre);
  const double cosine = to_centre.y / std::sqrt(squared);
  for (const float radius : {1e-4F, 0.01F, 0.5F, 2.5F}) {
    const MeanEstimate estimate =
        irradiance(lights_of(point(7.0F, radius)), place, Vec3(0, 1, 0), 20000);
    expect_mean(estimate, 7.0 * cosine / squared, 1e-5);
  }
}

TEST(PunctualLightsTest, SphereOnTheHorizonIsItsQuadrature) {
  // Seen from the centre of a vertical surface's horizon: half of the sphere counts.
  const float radius = 1.0F;
  const double half_angle = std::asin(1.0 / 3.0);
  constexpr int steps = 1000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double angle = half_angle * (i + 0.5) / steps;
    // The cosine's mean over the half circle that is above the horizon.
    sum += std::sin(angle) * std::sin(angle) / pi * 2.0 * pi * half_angle / steps;
  }
  const double expected = 4.0 / pi * sum;
  const MeanEstimate estimate =
      irradiance(lights_of(point(4.0F, radius)), Vec3(0, -1, 0), Vec3(1, 0, 0), 100000);
  expect_mean(estimate, expected, 1e-4);
}

TEST(PunctualLightsTest, InsideASphereItShinesAllAround) {
  const float radius = 2.0F;
  const double radiance = 4.0 / (pi * 4.0);
  for (const Vec3& place : {Vec3(0, 2, 0), Vec3(0.5F, 2.2F, -1), Vec3(0, 0.01F, 0)}) {
    const MeanEstimate estimate =
        irradiance(lights_of(point(4.0F, radius)), place, glm::normalize(Vec3(1, 2, 3)), 40000);
    expect_mean(estimate, pi * radiance, 1e-4);
  }
}

TEST(PunctualLightsTest, ShadowRaysEndOnTheSphere) {
  Pcg32 random(3);
  const PunctualLights lights = lights_of(point(4.0F, 0.5F));
  for (const Vec3& place : {Vec3(0, -1, 0), Vec3(30, -20, 7), Vec3(0.2F, 2.1F, 0)}) {
    for (int i = 0; i < 200; ++i) {
      const auto sample = lights.sample(0, place, unit_square(random));
      ASSERT_TRUE(sample);
      const double distance = glm::length(place - Vec3(0, 2, 0));
      EXPECT_NEAR(glm::length(place + sample->to_light - Vec3(0, 2, 0)), 0.5,
                  1e-5 * distance + 1e-5);
      EXPECT_LT(glm::length(sample->to_light), std::max(distance, 0.5 + 0.25));
    }
  }
}

TEST(PunctualLightsTest, SphereDirectionsAreUniformInItsSolidAngle) {
  struct Case {
    Vec3 place;
    double density;
    double cosine;
  };
  const double cosine = std::sqrt(1.0 - 0.25 / 0.36);
  const std::vector<Case> cases{{{0.6F, 2, 0}, 1.0 / (2.0 * pi * (1.0 - cosine)), cosine},
                                {{0.1F, 2.1F, 0}, 1.0 / (4.0 * pi), -2.0}};
  for (const Case& c : cases) {
    const PunctualLights lights = lights_of(point(4.0F, 0.5F));
    const Vec3 pole = glm::normalize(Vec3(0, 2, 0) - c.place);
    std::vector<Vec3> directions;
    Pcg32 random(4);
    for (int i = 0; i < 50000; ++i) {
      const auto sample = lights.sample(0, c.place, unit_square(random));
      ASSERT_TRUE(sample);
      EXPECT_NEAR(sample->pdf, c.density, 1e-5);
      directions.push_back(glm::normalize(sample->to_light));
    }
    const auto density = [&](const Vec3& w) {
      return glm::dot(w, pole) > c.cosine ? c.density : 0.0;
    };
    EXPECT_GT(test::chi_squared_p_value(directions, density, pole), sidak_level(2));
  }
}

TEST(PunctualLightsTest, RaysMeetWhatIsDrawn) {
  Pcg32 random(5);
  for (const PunctualLight& light : {point(4.0F, 0.5F), spot(0.3F, 0.5F, 0.1F)}) {
    const PunctualLights lights = lights_of(light);
    for (const Vec3& place : {Vec3(0, -1, 0), Vec3(0.4F, 0, 0.2F), Vec3(0.02F, 2.05F, 0)}) {
      for (int i = 0; i < 200; ++i) {
        const auto sample = lights.sample(0, place, unit_square(random));
        if (!sample) {
          continue;
        }
        const float distance = glm::length(sample->to_light);
        // Within the rim, where rounding decides.
        const Vec3 to_centre = light.position - place;
        const Vec3 direction =
            glm::normalize(glm::mix(sample->to_light / distance, to_centre, 1e-3F));
        const auto met = lights.hit(0, place, direction);
        ASSERT_TRUE(met);
        EXPECT_NEAR(met->t, distance, 0.06);
        EXPECT_EQ(met->radiance, sample->radiance);
        EXPECT_EQ(met->pdf, sample->pdf);
        EXPECT_TRUE(any_lane(lights.may_hit(all_lanes(place), all_lanes(direction))));
        EXPECT_FALSE(lights.hit(0, light.position + 2.0F * direction, direction));
      }
    }
  }
  EXPECT_TRUE(lights_of(point(4.0F)).spheres().empty());
}

TEST(PunctualLightsTest, SphericalSpotKeepsItsConeFromTheCentre) {
  const PunctualLights lights = lights_of(spot(0.3F, 0.5F, 0.1F));
  const double angle = 0.4;
  const Vec3 place(3.0 * std::sin(angle), 2.0 - 3.0 * std::cos(angle), 0.0);
  const Vec3 normal = glm::normalize(Vec3(0, 2, 0) - place);
  expect_mean(irradiance(lights, place, normal, 5000), 5.0 * attenuation(0.3, 0.5, angle) / 9.0,
              1e-4);
}

TEST(PunctualLightsTest, EverySampleIsFinite) {
  constexpr float largest = 1.0F - 0x1p-24F;
  for (const float radius : {0.0F, 1e-30F, 1e-3F, 1.0F, 1e6F}) {
    for (const PunctualLight& light : {point(1e-6F, radius), point(1e9F, radius),
                                       spot(0.0F, 0.0F, radius), spot(0.2F, 3.2F, radius)}) {
      const PunctualLights lights = lights_of(light);
      for (const float off : {0.0F, 1e-30F, 1e-3F, 1.0F, 1e6F}) {
        for (const Vec2& u : {Vec2(0.0F), Vec2(largest), Vec2(0.0F, largest), Vec2(0.5F, 0.0F)}) {
          const auto sample = lights.sample(0, Vec3(0, 2.0F - off, 0), u);
          if (sample) {
            EXPECT_TRUE(is_finite(sample->radiance) && is_finite(sample->to_light));
            EXPECT_TRUE(sample->pdf > 0.0F && std::isfinite(sample->pdf));
          }
        }
      }
    }
  }
}

TEST(PunctualLightsTest, BrokenAndBlackLightsAreLeftOut) {
  PunctualLight directional = point(1.0F);
  directional.kind = PunctualLight::Kind::directional;
  PunctualLight lost = point(1.0F);
  lost.position.x = std::numeric_limits<float>::quiet_NaN();
  PunctualLight aimless = spot(0.1F, 0.2F);
  aimless.direction = Vec3(0.0F);
  for (const PunctualLight& light : {directional, lost, aimless, spot(NAN, 1.0F),
                                     spot(0.0F, INFINITY), point(0.0F), point(INFINITY)}) {
    EXPECT_EQ(lights_of(light).size(), 0U);
  }
}

TEST(PunctualLightsTest, BrokenRadiiAreNone) {
  for (const float radius : {-1.0F, NAN, INFINITY}) {
    const auto sample = lights_of(point(12.0F, radius)).sample(0, Vec3(0, -1, 4), Vec2(0.5F));
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->to_light, Vec3(0, 3, -4));
    EXPECT_FLOAT_EQ(sample->radiance.g, 12.0F / 25.0F);
  }
}

}  // namespace
}  // namespace foveola
