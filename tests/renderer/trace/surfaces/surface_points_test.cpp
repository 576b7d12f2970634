#include "renderer/trace/surfaces/surface_points.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/trace/surfaces/surface.h"
#include "tests/renderer/trace/scenes.h"

namespace foveola {
namespace {

Vec3 random_vector(Pcg32& random, double scale) {
  Vec3 v;
  for (int axis = 0; axis < 3; ++axis) {
    v[axis] = static_cast<float>(scale * random.normal());
  }
  return v;
}

/// Triangles of sizes from 10^smallest to 10^3, their vertices' normals somewhat off their own.
Mesh loose_triangles(Pcg32& random, double smallest, bool has_normals) {
  Mesh mesh;
  for (std::uint32_t t = 0; t < 40; ++t) {
    const double size = std::pow(10.0, smallest + (3.0 - smallest) * random.uniform());
    const Vec3 place = random_vector(random, 10.0 * size);
    for (int vertex = 0; vertex < 3; ++vertex) {
      mesh.positions.push_back(place + random_vector(random, size));
    }
    const DVec3 corner(mesh.positions[3 * t]);
    const Vec3 normal(glm::normalize(glm::cross(DVec3(mesh.positions[3 * t + 1]) - corner,
                                                DVec3(mesh.positions[3 * t + 2]) - corner)));
    for (int vertex = 0; vertex < 3 && has_normals; ++vertex) {
      mesh.normals.push_back(glm::normalize(normal + random_vector(random, 0.3)));
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

Scene every_kind_of_object() {
  Pcg32 random(5);
  Scene scene;
  scene.materials = {matte(Rgb(0.5F))};
  scene.meshes = {loose_triangles(random, -9.0, true), loose_triangles(random, -9.0, false)};
  scene.prototypes = {loose_triangles(random, -2.0, true), loose_triangles(random, -2.0, false)};
  Mat4 mirrored(1.0F);
  mirrored[0] = Vec4(-2.0F, 0.3F, 0.0F, 0.0F);
  mirrored[3] = Vec4(4.0F, -1.0F, 7.0F, 1.0F);
  scene.instances = {{.prototype = 0, .world_from_local = mirrored},
                     {.prototype = 1, .world_from_local = Mat4(3.0F * Mat3(1.0F))}};
  return scene;
}

Vec3 at(const Vec3s& vectors, std::size_t lane) {
  return {vectors.x[lane], vectors.y[lane], vectors.z[lane]};
}

TEST(SurfacePointsTest, AreThoseOfSingleHits) {
  const Scene scene = every_kind_of_object();
  Pcg32 random(6);
  for (int i = 0; i < 500; ++i) {
    std::array<Hit, lane_count> hits;
    Vec3Lanes directions;
    Vec2Lanes barycentric;
    FloatLanes distance;
    SurfaceHits gathered;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      // The first rounds without instances.
      const std::uint32_t object = random.below(i < 100 ? 2 : 4);
      const auto u = static_cast<float>(0.5 * random.uniform());
      const auto v = static_cast<float>(0.5 * random.uniform());
      hits[lane] = {.t = static_cast<float>(1e-3 + random.exponential()),
                    .barycentric = {u, v},
                    .object = object,
                    .triangle = random.below(40)};
      directions.put(lane, glm::normalize(random_vector(random, 1.0)));
      barycentric.x[lane] = u;
      barycentric.y[lane] = v;
      distance[lane] = hits[lane].t;
      gathered.put(lane, {&scene.mesh_of(object), scene.instance_of(object)}, hits[lane].triangle);
    }
    const SurfacePoints points =
        gathered.points(directions.load(), barycentric.load(), distance.load());
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const SurfacePoint expected = surface_point(scene, hits[lane], directions.at(lane));
      EXPECT_EQ(at(points.position, lane), expected.position);
      EXPECT_EQ(points.rounding_error[lane], expected.rounding_error);
      EXPECT_NEAR(glm::length(at(points.geometric_normal, lane) - expected.geometric_normal), 0.0F,
                  1e-6F);
      EXPECT_NEAR(glm::length(at(points.origin, lane) - expected.origin), 0.0F,
                  1e-2F * expected.rounding_error);
      EXPECT_NEAR(glm::length(at(points.shading_normal, lane) - expected.shading_normal), 0.0F,
                  1e-5F)
          << hits[lane].object;
    }
  }
}

TEST(SurfacePointsTest, AMappedNormalThatIsTurnedAwayIsNotUsed) {
  Scene scene;
  scene.materials = {matte(Rgb(0.5F))};
  scene.meshes = {quad(Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 0, -1), 0)};
  SurfaceHits hits;
  hits.put(2, {scene.meshes.data(), nullptr}, 0);
  for (const float side : {1.0F, -1.0F}) {
    const Vec3s direction = all_lanes(glm::normalize(Vec3(1.0F, -0.1F * side, 0.0F)));
    SurfacePoints points = hits.points(direction, {Floats{}, all_lanes(0.5F)}, all_lanes(1.0F));
    const Vec3 up(0.0F, side, 0.0F);
    EXPECT_EQ(at(points.shading_normal, 2), up);
    points.turn_shading_normal(2, direction, glm::normalize(Vec3(side, 1.0F, 0.0F)));
    EXPECT_EQ(at(points.shading_normal, 2), up);
    const Vec3 leaning = glm::normalize(Vec3(-side, 1.0F, 0.0F));
    points.turn_shading_normal(2, direction, leaning);
    EXPECT_EQ(at(points.shading_normal, 2), side * leaning);
  }
}

}  // namespace
}  // namespace foveola
