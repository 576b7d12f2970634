// Lights that a scattered ray meets by chance or behind mirrors and glass: spheres, and suns
// through panes, against closed forms and quadrature.
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "tests/renderer/trace/paths.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

using std::numbers::pi;

constexpr double glass_index = 1.5;

/// Fresnel's reflectance for unpolarised light (Born and Wolf, section 1.5.2).
double fresnel(double cosine, double refracted_cosine, double eta) {
  const double s = (cosine - eta * refracted_cosine) / (cosine + eta * refracted_cosine);
  const double p = (eta * cosine - refracted_cosine) / (eta * cosine + refracted_cosine);
  return (s * s + p * p) / 2.0;
}

/// What happens to a direction where it crosses an interface along its normal's side.
struct Crossing {
  DVec3 direction;
  double transmitted;
};
std::optional<Crossing> crossing(const DVec3& direction, const DVec3& normal, double eta) {
  const double cosine = glm::dot(direction, normal);
  const double squared = 1.0 - (1.0 - cosine * cosine) / (eta * eta);
  if (cosine <= 0.0 || squared <= 0.0) {
    return std::nullopt;
  }
  const double refracted = std::sqrt(squared);
  return Crossing{direction / eta + (refracted - cosine / eta) * normal,
                  1.0 - fresnel(cosine, refracted, eta)};
}

double plate_reflectance(double cosine) {
  const double sine = std::sqrt(1.0 - cosine * cosine) / glass_index;
  return fresnel(cosine, std::sqrt(1.0 - sine * sine), glass_index);
}

// --- Spheres ---------------------------------------------------------------------------------

constexpr float sphere_intensity = 10.0F;
constexpr float sphere_radius = 0.3F;
const double radiance_of_sphere = sphere_intensity / (pi * sphere_radius * sphere_radius);

/// A lamp at (0, 1, -3), of radiance 35.37.
Scene lamp_scene() {
  Scene scene;
  scene.lights = {
      {.position = {0, 1, -3}, .intensity = Rgb(sphere_intensity), .radius_m = sphere_radius}};
  return scene;
}

Mesh ground(const Vec3& corner = Vec3(-20, 0, 20)) {
  return quad(corner, Vec3(40, 0, 0), Vec3(0, 0, -40), 0);
}

TEST(MetLightsTest, ASphereIsSeenAndMirroredWithItsRadiance) {
  const Vec3 eye(0, 1, 3);
  const auto seen = [&](const Scene& scene, const Vec3& towards) {
    return mean_radiance(scene, eye, towards - eye, 3, 4000);
  };
  Scene scene = lamp_scene();
  EXPECT_NEAR(seen(scene, {0, 1, -3}).mean(), radiance_of_sphere, 1e-4);
  EXPECT_NEAR(seen(scene, {0, 1.29F, -3}).mean(), radiance_of_sphere, 1e-4);
  EXPECT_EQ(seen(scene, {0, 1.31F, -3}).mean(), 0.0);

  const Vec3 image(0, -1, -3);
  scene.materials = {metal(1.0F, 0.0F)};
  scene.meshes = {ground()};
  EXPECT_NEAR(seen(scene, image).mean(), radiance_of_sphere, 1e-3);
  const double cosine = 1.0 / std::sqrt(10.0);
  scene.materials = {matte(Rgb(0.0F))};
  scene.materials[0].clearcoat = 1.0F;
  expect_mean(seen(scene, image), radiance_of_sphere * (0.04 + 0.96 * std::pow(1.0 - cosine, 5.0)));

  scene.materials = {matte(Rgb(0.0F))};
  scene.meshes = {quad(Vec3(-1, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), 0)};
  EXPECT_EQ(seen(scene, {0, 1, -3}).mean(), 0.0) << "behind a wall";
}

/// Walls of glass all around, whose two surfaces are met at right angles.
TEST(MetLightsTest, ASphereIsSeenInABulbOfGlass) {
  Scene scene = lamp_scene();
  scene.materials = {glass()};
  scene.meshes = {inside_out(inward_box(Vec3(0, 1, -3), 0.5F, 0)),
                  inward_box(Vec3(0, 1, -3), 0.45F, 0)};
  const double passes = 1.0 - plate_reflectance(1.0);
  expect_mean(mean_radiance(scene, Vec3(0.01F, 1.02F, 3), Vec3(0, 0, -1), 2, 20000),
              radiance_of_sphere * passes * passes);
}

TEST(MetLightsTest, ASpotsSphereShinesWithinItsCone) {
  Scene scene = lamp_scene();
  PunctualLight& spot = scene.lights[0];
  spot.kind = PunctualLight::Kind::spot;
  spot.direction = {0, 0, 1};
  spot.outer_cone_rad = 0.5F;
  const auto seen_at = [&](double angle) {
    const DVec3 aside(std::sin(angle), 0.0, std::cos(angle));
    return mean_radiance(scene, Vec3(DVec3(spot.position) + 4.0 * aside), Vec3(-aside), 1, 10)
        .mean();
  };
  const double t = (std::cos(0.3) - std::cos(0.5)) / (1.0 - std::cos(0.5));
  EXPECT_NEAR(seen_at(0.3), radiance_of_sphere * t * t, 1e-3);
  EXPECT_EQ(seen_at(0.6), 0.0);
}

/// Light from a sphere through a horizontal pane, refracted by Snell's law: the point of the floor
/// below its centre, in rings of directions.
TEST(MetLightsTest, ASphereShinesThroughAPane) {
  constexpr double height = 2.0;
  constexpr double radius = 0.3;
  constexpr double thickness = 0.1;
  Scene scene;
  scene.materials = {matte(Rgb(0.8F)), glass()};
  scene.meshes = {ground(), quad(Vec3(-20, 1, -20), Vec3(40, 0, 0), Vec3(0, 0, 40), 1),
                  quad(Vec3(-20, 1.1F, -20), Vec3(0, 0, 40), Vec3(40, 0, 0), 1)};
  scene.lights = {{.position = {0, 2, 0}, .intensity = Rgb(sphere_intensity), .radius_m = 0.3F}};
  constexpr int steps = 100000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double angle = 0.5 * (i + 0.5) / steps;
    const double inside = std::asin(std::sin(angle) / glass_index);
    // The ray's distance from the centre, as it leaves the pane.
    const double aside =
        (height - thickness) * std::sin(angle) + thickness * std::tan(inside) * std::cos(angle);
    const double passes = 1.0 - plate_reflectance(std::cos(angle));
    sum += aside < radius ? passes * passes * std::cos(angle) * std::sin(angle) * 0.5 / steps : 0.0;
  }
  const double expected = 0.8 / pi * 2.0 * pi * sum * radiance_of_sphere;
  expect_mean(mean_radiance(scene, Vec3(-0.5F, 0.5F, 0), Vec3(0.5F, -0.5F, 0), 3, 400000), expected,
              2e-4, 0.02);
}

// --- Suns ------------------------------------------------------------------------------------

constexpr double floor_albedo = 0.5;
constexpr double sun_irradiance = 3.0;
const DVec3 towards_sun(-std::sin(radians(40.0)), std::cos(radians(40.0)), 0.0);

/// A floor under a pane or wedge of glass that is 0.5 thick where the floor is looked at, and a
/// sun.
Scene glazed_floor(double wedge_rad, double sun_radius_rad) {
  constexpr float side = 400.0F;
  const Vec3 slope(std::cos(wedge_rad), -std::sin(wedge_rad), 0.0);
  const Vec3 z(0, 0, 1);
  Scene scene;
  scene.materials = {matte(Rgb(static_cast<float>(floor_albedo))), glass()};
  scene.meshes = {quad(-0.5F * side * Vec3(1, 0, 1), side * z, side * Vec3(1, 0, 0), 0),
                  quad(Vec3(-0.5F * side, 1, -0.5F * side), side * Vec3(1, 0, 0), side * z, 1),
                  quad(Vec3(0, 1.5F, 0) - 0.5F * side * (slope + z), side * z, side * slope, 1)};
  scene.lights = {{.kind = PunctualLight::Kind::directional,
                   .direction = Vec3(-towards_sun),
                   .intensity = Rgb(static_cast<float>(sun_irradiance)),
                   .angular_radius_rad = static_cast<float>(sun_radius_rad)}};
  return scene;
}

MeanEstimate floor_below_glass(const Scene& scene, int max_depth, std::uint32_t samples) {
  return mean_radiance(scene, Vec3(-0.5F, 0.5F, 0), Vec3(0.5F, -0.5F, 0), max_depth, samples);
}

/// The floor's radiance from what arrives by two refractions, over directions from the floor.
double refracted_radiance(double wedge_rad, const std::function<double(const DVec3&)>& arriving) {
  const DVec3 slope_normal(std::sin(wedge_rad), std::cos(wedge_rad), 0.0);
  constexpr int steps = 1500;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double up = (i + 0.5) / steps;
    const double across = std::sqrt(1.0 - up * up);
    for (int k = 0; k < steps; ++k) {
      const double azimuth = 2.0 * pi * (k + 0.5) / steps;
      const DVec3 w(across * std::cos(azimuth), up, across * std::sin(azimuth));
      const auto entering = crossing(w, DVec3(0.0, 1.0, 0.0), glass_index);
      const auto leaving = crossing(entering->direction, slope_normal, 1.0 / glass_index);
      if (leaving) {
        sum += up * entering->transmitted * leaving->transmitted * arriving(leaving->direction);
      }
    }
  }
  return floor_albedo / pi * sum * 2.0 * pi / (steps * steps);
}

/// 0.27 degrees: about as wide as the Sun.
TEST(MetLightsTest, ASunShinesThroughAPaneWithLittleNoise) {
  const Scene scene = glazed_floor(0.0, radians(0.27));
  const double reflected = plate_reflectance(towards_sun.y);
  const double bare = floor_albedo / pi * sun_irradiance * towards_sun.y;
  expect_mean(floor_below_glass(scene, 3, 4096), bare * std::pow(1.0 - reflected, 2.0), 1e-4);
  // With all reflections within the pane, and between an infinite floor and an infinite pane.
  const auto of_plate = [](double r) { return 2.0 * r / (1.0 + r); };
  constexpr int steps = 10000;
  double diffuse = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + 0.5) / steps;
    diffuse += of_plate(plate_reflectance(cosine)) * 2.0 * cosine / steps;
  }
  expect_mean(floor_below_glass(scene, 40, 4096),
              bare * (1.0 - of_plate(reflected)) / (1.0 - floor_albedo * diffuse), 1e-3, 0.05);
}

/// What is sampled towards the sun and what meets it by chance add up, where glass bends light into
/// the disc and out of it, and with a sky around the disc.
TEST(MetLightsTest, SunsThroughGlassCountOnce) {
  constexpr double radius = 0.35;
  const double radiance = sun_irradiance / (pi * std::pow(std::sin(radius), 2.0));
  const auto sun = [&](const DVec3& w) {
    return glm::dot(w, towards_sun) > std::cos(radius) ? radiance : 0.0;
  };
  const double wedge = radians(10.0);
  expect_mean(floor_below_glass(glazed_floor(wedge, radius), 3, 100000),
              refracted_radiance(wedge, sun), 3e-3);

  constexpr double sky = 0.7;
  Scene under_a_sky = glazed_floor(0.0, radius);
  under_a_sky.environment = constant_environment(static_cast<float>(sky));
  expect_mean(floor_below_glass(under_a_sky, 3, 100000),
              refracted_radiance(0.0, [&](const DVec3& w) { return sky + sun(w); }), 3e-3);
}

// --- Bright spots of environment images ------------------------------------------------------

/// An image of one radiance, but for a texel in the sky, between whose centre and its neighbours'
/// the radiance falls linearly.
struct SpotInSky {
  int width, height, column, row;
  float sky, brightest;

  Environment environment() const {
    Environment image{.map_width = width, .map_height = height};
    image.map.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Rgb(sky));
    image.map[static_cast<std::size_t>(row * width + column)] = Rgb(brightest);
    return image;
  }
  double elevation() const { return pi * (0.5 - (row + 0.5) / height); }
  double radiance(const DVec3& w) const {
    const double x = (std::atan2(w.x, -w.z) / (2.0 * pi) + 0.5) * width - 0.5 - column;
    const double y = (0.5 - std::asin(w.y) / pi) * height - 0.5 - row;
    const double share = std::max(0.0, 1.0 - std::abs(x)) * std::max(0.0, 1.0 - std::abs(y));
    return sky + share * (brightest - sky);
  }
};

/// Half a degree wide. A sun without a size in the same direction stays invisible.
TEST(MetLightsTest, ASunInAnImageShinesThroughAPaneWithLittleNoise) {
  const SpotInSky spot{722, 361, 180, 80, 0.0F, 10000.0F};
  Scene scene = glazed_floor(0.0, 0.0);
  scene.environment = spot.environment();
  const double height = std::sin(spot.elevation());
  const double irradiance = spot.brightest * std::cos(spot.elevation()) * 2.0 * pi * pi /
                            (static_cast<double>(spot.width) * spot.height);
  expect_mean(
      floor_below_glass(scene, 3, 4096),
      floor_albedo / pi * irradiance * height * std::pow(1.0 - plate_reflectance(height), 2.0),
      2e-3, 0.05);
}

TEST(MetLightsTest, SpotsOfAnImageThroughGlassCountOnce) {
  const SpotInSky spot{32, 16, 8, 3, 0.7F, 200.0F};
  for (const double wedge : {0.0, radians(10.0)}) {
    Scene scene = glazed_floor(wedge, 0.0);
    scene.lights.clear();
    scene.environment = spot.environment();
    expect_mean(floor_below_glass(scene, 3, 200000),
                refracted_radiance(wedge, [&](const DVec3& w) { return spot.radiance(w); }), 3e-3);
  }
}

// --- Lights without a size -------------------------------------------------------------------

TEST(MetLightsTest, LightsThatNoPathFindsAreWarnedOfOnce) {
  const auto warnings = [](const Scene& scene) { return PathTracer(scene, workers()).warnings(); };
  Scene scene = glazed_floor(0.0, 0.0);
  ASSERT_EQ(warnings(scene).size(), 1U);
  EXPECT_NE(warnings(scene)[0].find("--sun-radius"), std::string::npos);
  EXPECT_EQ(warnings(scene)[0].find("--light-radius"), std::string::npos);
  scene.lights.push_back({.intensity = Rgb(1.0F)});
  ASSERT_EQ(warnings(scene).size(), 1U);
  EXPECT_NE(warnings(scene)[0].find("(2)"), std::string::npos);
  EXPECT_NE(warnings(scene)[0].find("--light-radius"), std::string::npos);
  scene.materials[1] = metal(1.0F, 0.0F);
  EXPECT_EQ(warnings(scene).size(), 1U);
  scene.materials[1] = glass(0.3F);
  ASSERT_EQ(warnings(scene).size(), 1U);
  EXPECT_EQ(warnings(scene)[0].find("invisible"), std::string::npos);
  scene.materials[1] = glass();
  scene.lights[0].angular_radius_rad = 0.01F;
  scene.lights[1].radius_m = 0.1F;
  EXPECT_EQ(warnings(scene).size(), 0U);
}

TEST(MetLightsTest, SmallLightsBehindGlassAreWarnedOf) {
  const auto noise = [](const Scene& scene) {
    const std::vector<std::string> lines = PathTracer(scene, workers()).warnings();
    return lines.size() == 1 ? lines[0].substr(0, lines[0].find(" glass")) : "";
  };
  Scene scene = glazed_floor(0.0, radians(0.27));
  EXPECT_EQ(noise(scene), "");
  scene.lights.push_back({.position = {0, 3, 0}, .intensity = Rgb(1.0F), .radius_m = 0.01F});
  EXPECT_EQ(noise(scene), "small lights (1) behind solid");
  scene.materials.push_back(emitter(10.0F));
  scene.meshes.push_back(quad(Vec3(0, 3, 0), Vec3(0.04F, 0, 0), Vec3(0, 0, 0.04F), 2));
  EXPECT_EQ(noise(scene), "small lights (2) behind solid");
  scene.materials[1] = glass(0.1F);
  EXPECT_EQ(noise(scene), "small lights (3) behind rough or solid");
  scene.environment = SpotInSky{722, 361, 180, 80, 0.1F, 10000.0F}.environment();
  EXPECT_EQ(noise(scene), "small lights (4) behind rough or solid");
  scene.materials[1] = matte(Rgb(0.5F));
  EXPECT_EQ(noise(scene), "");
}

}  // namespace
}  // namespace foveola
