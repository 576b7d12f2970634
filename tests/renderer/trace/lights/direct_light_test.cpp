// What a floor reflects of one light, through the whole tracer, against quadrature.
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/renderer/trace/paths.h"
#include "tests/renderer/trace/reference_bsdf.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

using std::numbers::pi;
const std::vector<ReferenceMaterial>& floors() {
  static const std::vector<ReferenceMaterial> materials{{0.8, 0.0, 1.0}, {0.9, 1.0, 0.4}};
  return materials;
}

/// A floor at y = 0, seen from (-1, 1, 0) where the ray meets it at the origin.
Scene floor_of(const ReferenceMaterial& material) {
  Scene scene;
  scene.materials = {
      dielectric(static_cast<float>(material.base), static_cast<float>(material.roughness))};
  scene.materials[0].metallic = static_cast<float>(material.metallic);
  scene.meshes = {quad(Vec3(-9, 0, 9), Vec3(18, 0, 0), Vec3(0, 0, -18), 0)};
  return scene;
}

MeanEstimate seen(const Scene& scene, std::uint32_t samples = 40000) {
  return mean_radiance(scene, Vec3(-1, 1, 0), Vec3(1, -1, 0), 1, samples);
}

/// What the floor sends to the viewpoint of light from the unit direction `w` of the world, per
/// radiance and steradian.
double reflected(const ReferenceMaterial& material, const ReferenceCoat& coat, const DVec3& w) {
  const double a = std::sqrt(0.5);
  // Local coordinates of the floor: x, -z, y.
  return w.y > 0.0 ? reference_bsdf(material, coat, {-a, 0.0, a}, {w.x, -w.z, w.y}) * w.y : 0.0;
}

/// The mean over the disc of directions within `radius_rad` of `axis`, by solid angle.
double mean_over_disc(const Vec3& axis, double radius_rad,
                      const std::function<double(const DVec3&)>& value) {
  constexpr int steps = 200;
  const Frame frame(axis);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double cosine = 1.0 - (i + 0.5) / steps * (1.0 - std::cos(radius_rad));
    const double sine = std::sqrt(1.0 - cosine * cosine);
    for (int k = 0; k < steps; ++k) {
      const double azimuth = 2.0 * pi * (k + 0.5) / steps;
      sum += value(sine * std::cos(azimuth) * DVec3(frame.tangent) +
                   sine * std::sin(azimuth) * DVec3(frame.bitangent) + cosine * DVec3(axis));
    }
  }
  return sum / (steps * steps);
}

TEST(DirectLightTest, PointsAndSpots) {
  const Vec3 position(0.5F, 2, 1);
  const double squared = glm::dot(position, position);
  PunctualLight point{.position = position, .intensity = Rgb(9.0F)};
  PunctualLight spot = point;
  spot.kind = PunctualLight::Kind::spot;
  spot.direction = glm::normalize(Vec3(0.3F, 0, 0) - position);
  spot.inner_cone_rad = 0.05F;
  spot.outer_cone_rad = 0.4F;
  const double cosine = glm::dot(DVec3(spot.direction), -glm::normalize(DVec3(position)));
  const double rim = (cosine - std::cos(0.4)) / (std::cos(0.05) - std::cos(0.4));
  ASSERT_GT(rim, 0.1);
  ASSERT_LT(rim, 0.95);
  for (const ReferenceMaterial& material : floors()) {
    const ReferenceCoat coat(material.alpha());
    const double expected =
        9.0 / squared * reflected(material, coat, glm::normalize(DVec3(position)));
    Scene scene = floor_of(material);
    scene.lights = {point};
    EXPECT_NEAR(seen(scene, 1000).mean(), expected, 2e-3 * expected);
    scene.lights = {spot};
    EXPECT_NEAR(seen(scene, 1000).mean(), expected * rim * rim, 3e-3 * expected);
    // A plate between light and floor.
    scene.meshes.push_back(quad(Vec3(-0.5F, 1, -0.5F), Vec3(2, 0, 0), Vec3(0, 0, 2), 0));
    EXPECT_EQ(seen(scene, 100).mean(), 0.0);
  }
}

TEST(DirectLightTest, Suns) {
  const Vec3 towards = glm::normalize(Vec3(0.7F, 1, 0.2F));
  for (const ReferenceMaterial& material : floors()) {
    const ReferenceCoat coat(material.alpha());
    const auto value = [&](const DVec3& w) { return reflected(material, coat, w); };
    for (const float radius : {0.0F, 0.00465F, 0.3F}) {
      Scene scene = floor_of(material);
      scene.lights = {{.kind = PunctualLight::Kind::directional,
                       .direction = -towards,
                       .intensity = Rgb(3.0F),
                       .angular_radius_rad = radius}};
      // Radiance times solid angle of the disc, over its irradiance.
      const double excess = radius > 0.0F ? 2.0 / (1.0 + std::cos(radius)) : 1.0;
      const double expected = 3.0 * excess * mean_over_disc(towards, radius, value);
      expect_mean(seen(scene), expected, 2e-3);
    }
  }
}

/// A lamp of a given radius: its sphere is a disc of directions.
TEST(DirectLightTest, SphericalLamps) {
  const Vec3 position(0.5F, 2, 1);
  const double distance = glm::length(position);
  for (const ReferenceMaterial& material : floors()) {
    const ReferenceCoat coat(material.alpha());
    const auto value = [&](const DVec3& w) { return reflected(material, coat, w); };
    for (const float radius : {0.05F, 1.2F}) {
      Scene scene = floor_of(material);
      scene.lights = {{.position = position, .intensity = Rgb(9.0F), .radius_m = radius}};
      const double half_angle = std::asin(radius / distance);
      const double solid_angle = 2.0 * pi * (1.0 - std::cos(half_angle));
      const double expected = 9.0 / (pi * radius * radius) * solid_angle *
                              mean_over_disc(glm::normalize(position), half_angle, value);
      expect_mean(seen(scene), expected, 2e-3, 0.02);
    }
  }
}

/// A rectangle of radiance 5 at y = 1, |x| < 0.5, |z| < 1, cut into `cuts` squared quads.
Mesh tiled_lamp(int cuts) {
  Mesh mesh;
  mesh.material = 1;
  const auto step = 1.0F / static_cast<float>(cuts);
  for (int i = 0; i <= cuts; ++i) {
    for (int k = 0; k <= cuts; ++k) {
      mesh.positions.push_back(
          {static_cast<float>(i) * step - 0.5F, 1.0F, 2.0F * static_cast<float>(k) * step - 1.0F});
    }
  }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i * (cuts + 1) + k); };
  for (int i = 0; i < cuts; ++i) {
    for (int k = 0; k < cuts; ++k) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh;
}

double lamp_radiance(const ReferenceMaterial& material) {
  const ReferenceCoat coat(material.alpha());
  constexpr int steps = 400;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      const DVec3 to((i + 0.5) / steps - 0.5, 1.0, 2.0 * (k + 0.5) / steps - 1.0);
      const double squared = glm::dot(to, to);
      const DVec3 w = to / std::sqrt(squared);
      sum += reflected(material, coat, w) * w.y / squared;
    }
  }
  return 5.0 * 2.0 * sum / (steps * steps);
}

/// Two triangles by solid angle, then some by area, then many through the tree.
TEST(DirectLightTest, OneLampHoweverItIsCut) {
  for (const ReferenceMaterial& material : floors()) {
    const double expected = lamp_radiance(material);
    for (const int cuts : {1, 3, 40}) {
      Scene scene = floor_of(material);
      scene.materials.push_back(emitter(5.0F));
      scene.meshes.push_back(tiled_lamp(cuts));
      expect_mean(seen(scene), expected, 1.5e-3, 0.015);
    }
  }
}

TEST(DirectLightTest, AMirroredInstanceOfALampShinesDown) {
  const ReferenceMaterial material{0.9, 1.0, 0.4};
  Scene scene = floor_of(material);
  scene.materials.push_back(emitter(5.0F));
  scene.prototypes = {tiled_lamp(4)};
  for (Vec3& position : scene.prototypes[0].positions) {
    position = Vec3(-2.0F * position.x, position.y - 1.0F, position.z);
  }
  for (auto& triangle : scene.prototypes[0].triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  Mat4 mirror(1.0F);
  mirror[0][0] = -0.5F;
  mirror[3] = {0, 1, 0, 1};
  scene.instances = {{.prototype = 0, .world_from_local = mirror}};
  expect_mean(seen(scene), lamp_radiance(material), 1.5e-3, 0.015);
}

/// A sky that is bright in one place, turned to where the floor mirrors it.
TEST(DirectLightTest, RotatedSky) {
  const ReferenceMaterial material{0.9, 1.0, 0.4};
  const ReferenceCoat coat(material.alpha());
  constexpr int width = 64;
  constexpr int height = 32;
  Environment sky;
  sky.map_width = width;
  sky.map_height = height;
  sky.map.assign(width * height, Rgb(0.2F));
  // Beside the image's seam, around azimuth -pi + 3.5 texels; then turned to azimuth 1.4.
  for (std::size_t y = 6; y < 10; ++y) {
    for (std::size_t x = 1; x < 6; ++x) {
      sky.map[y * width + x] = Rgb(30.0F);
    }
  }
  const double azimuth_of_spot = (3.5 / width - 0.5) * 2.0 * pi;
  sky.rotation_rad = 1.4 - azimuth_of_spot;

  // Radiance by the map's convention, written out: bilinear between texel centres.
  const auto radiance = [&](const DVec3& w) {
    double u = (std::atan2(w.x, -w.z) - sky.rotation_rad) / (2.0 * pi) + 0.5;
    u -= std::floor(u);
    const double v = 0.5 - std::asin(std::clamp(w.y, -1.0, 1.0)) / pi;
    const double x = u * width - 0.5;
    const double y = std::clamp(v * height - 0.5, 0.0, height - 1.0);
    double sum = 0.0;
    for (int i = 0; i < 2; ++i) {
      for (int k = 0; k < 2; ++k) {
        const int column = (static_cast<int>(std::floor(x)) + i + width) % width;
        const int row = std::min(static_cast<int>(y) + k, height - 1);
        const double weight_x = i == 0 ? 1.0 - (x - std::floor(x)) : x - std::floor(x);
        const double weight_y = k == 0 ? 1.0 - (y - std::floor(y)) : y - std::floor(y);
        sum += weight_x * weight_y * sky.map[static_cast<std::size_t>(row * width + column)].g;
      }
    }
    return sum;
  };
  const double mean = mean_over_disc(Vec3(0, 1, 0), 0.5 * pi, [&](const DVec3& w) {
    return reflected(material, coat, w) * radiance(w);
  });
  Scene scene = floor_of(material);
  scene.environment = sky;
  expect_mean(seen(scene), 2.0 * pi * mean, 5e-3, 0.02);
}

}  // namespace
}  // namespace foveola
