// Lights that lie in one place with others: what is seen is what lights.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/trace/paths/path_tracer.h"
#include "tests/renderer/trace/paths.h"
#include "tests/renderer/trace/scenes.h"

namespace foveola {
namespace {

constexpr double albedo = 0.5;

/// A part of the plane y = 1, its front below.
struct Rectangle {
  double x0 = -1.0;
  double z0 = -1.0;
  double x1 = 1.0;
  double z1 = 1.0;

  Mesh mesh(int material) const {
    return quad(Vec3(x0, 1.0, z0), Vec3(x1 - x0, 0.0, 0.0), Vec3(0.0, 0.0, z1 - z0), material);
  }
  /// Of the floor's light at the origin where the rectangle shines with radiance 1, by the view
  /// factor of a rectangle with a corner straight above (Howell, A Catalog of Radiation Heat
  /// Transfer Configuration Factors, B-3).
  double view_factor() const {
    const auto corner = [](double a, double b) {
      const double u = std::sqrt(1.0 + a * a);
      const double v = std::sqrt(1.0 + b * b);
      return (a / u * std::atan(b / u) + b / v * std::atan(a / v)) / (2.0 * std::numbers::pi);
    };
    return corner(x1, z1) - corner(x0, z1) - corner(x1, z0) + corner(x0, z0);
  }
};

constexpr Rectangle whole;

Scene floor_scene(std::vector<Material> lights) {
  Scene scene;
  scene.materials = {matte(Rgb(albedo))};
  scene.materials.insert(scene.materials.end(), lights.begin(), lights.end());
  scene.meshes = {quad(Vec3(-9, 0, 9), Vec3(18, 0, 0), Vec3(0, 0, -18), 0)};
  return scene;
}

/// Of the floor under the lights, by both kinds of vertices. The ray to it passes below them.
void expect_floor(const Scene& scene, double expected) {
  const PathTracer tracer(scene, workers());
  const Vec3 viewpoint(-0.9F, 0.9F, 0.0F);
  const std::vector<SampleJob> jobs = jobs_along(-viewpoint, 20'000);
  for (const bool general : {false, true}) {
    std::vector<Rgb> radiance(jobs.size());
    tracer.trace(viewpoint, jobs, radiance,
                 {.max_depth = 1, .seed = 1, .uses_general_path = general}, workers());
    expect_mean(mean_of(radiance), albedo * expected, 1e-3);
  }
}

/// What is seen where a ray goes straight up at a place of the floor.
double seen_above(const Scene& scene, const Vec3& place) {
  return mean_radiance(scene, place, Vec3(0.1F, 1.0F, 0.03F), 1, 500).mean();
}

TEST(CoincidentSurfacesTest, ALightByItselfIsItsViewFactor) {
  Scene scene = floor_scene({lamp(Rgb(10.0F), true)});
  scene.meshes.push_back(whole.mesh(1));
  expect_floor(scene, 10.0 * whole.view_factor());
  EXPECT_NEAR(10.0 * whole.view_factor(), 5.541, 5e-4);
  EXPECT_TRUE(PathTracer(scene, workers()).warnings().empty());
}

TEST(CoincidentSurfacesTest, CopiesLightOnce) {
  Scene scene = floor_scene({lamp(Rgb(10.0F), true)});
  scene.meshes.push_back(whole.mesh(1));
  Scene with_mesh = scene;
  // Its diagonal is the other one.
  with_mesh.meshes.push_back(quad(Vec3(1, 1, -1), Vec3(0, 0, 2), Vec3(-2, 0, 0), 1));
  expect_floor(with_mesh, 10.0 * whole.view_factor());
  EXPECT_EQ(PathTracer(with_mesh, workers()).warnings().size(), 1U);
  Scene with_instances = scene;
  with_instances.meshes.pop_back();
  with_instances.prototypes = {whole.mesh(1)};
  for (Vec3& position : with_instances.prototypes[0].positions) {
    position = 3.0F * position - Vec3(0.1F, 0.7F, 0.3F);
  }
  Mat4 place(1.0F / 3.0F);
  place[3] = Vec4(Vec3(0.1F, 0.7F, 0.3F) / 3.0F, 1.0F);
  with_instances.instances = {{.name = "", .prototype = 0, .world_from_local = place},
                              {.name = "", .prototype = 0, .world_from_local = place}};
  expect_floor(with_instances, 10.0 * whole.view_factor());
}

TEST(CoincidentSurfacesTest, APartialOverlapLightsAsItsUnion) {
  Scene scene = floor_scene({lamp(Rgb(10.0F), true)});
  scene.meshes.push_back(whole.mesh(1));
  scene.meshes.push_back(Rectangle{.x0 = 0.3, .z0 = -0.4, .x1 = 2.0, .z1 = 0.4}.mesh(1));
  const Rectangle rest{.x0 = 1.0, .z0 = -0.4, .x1 = 2.0, .z1 = 0.4};
  expect_floor(scene, 10.0 * (whole.view_factor() + rest.view_factor()));
}

TEST(CoincidentSurfacesTest, NeighboursDoNotOverlap) {
  Scene scene = floor_scene({lamp(Rgb(10.0F), true)});
  scene.meshes.push_back(tessellated_quad(Vec3(-1, 1, -1), Vec3(2, 0, 0), Vec3(0, 0, 2), 8, 1));
  EXPECT_TRUE(PathTracer(scene, workers()).warnings().empty());
}

// Whichever is hit: without a rule for it, the back of the one was in the way of the other.
TEST(CoincidentSurfacesTest, OneSidedLightsBackToBackBothShine) {
  for (const bool lower_first : {false, true}) {
    Scene scene = floor_scene({lamp(Rgb(10.0F)), lamp(Rgb(3.0F))});
    scene.meshes.push_back(lower_first ? whole.mesh(1) : inside_out(whole.mesh(2)));
    scene.meshes.push_back(lower_first ? inside_out(whole.mesh(2)) : whole.mesh(1));
    expect_floor(scene, 10.0 * whole.view_factor());
    EXPECT_TRUE(PathTracer(scene, workers()).warnings().empty());
    EXPECT_NEAR(seen_above(scene, Vec3(0.2F, 0.5F, 0.1F)), 10.0, 1e-5);
    EXPECT_NEAR(mean_radiance(scene, Vec3(0.2F, 2, 0.1F), Vec3(0, -1, 0), 1, 500).mean(), 3.0,
                1e-5);
  }
}

TEST(CoincidentSurfacesTest, OfTwoRadiancesTheOneThatIsSeenLights) {
  for (const float first : {10.0F, 4.0F}) {
    Scene scene = floor_scene({lamp(Rgb(first), true), lamp(Rgb(14.0F - first), true)});
    scene.meshes.push_back(whole.mesh(1));
    scene.meshes.push_back(whole.mesh(2));
    expect_floor(scene, first * whole.view_factor());
    EXPECT_NEAR(seen_above(scene, Vec3(0.2F, 0.5F, 0.1F)), first, 1e-5);
  }
}

TEST(CoincidentSurfacesTest, ASurfaceInItsPlaneHidesNoLight) {
  for (const bool ceiling_first : {false, true}) {
    Scene scene = floor_scene({lamp(Rgb(10.0F), true), matte(Rgb(0.0F))});
    const Mesh ceiling = Rectangle{.x0 = -2, .z0 = -2, .x1 = 2, .z1 = 2}.mesh(2);
    scene.meshes.push_back(ceiling_first ? ceiling : whole.mesh(1));
    scene.meshes.push_back(ceiling_first ? whole.mesh(1) : ceiling);
    expect_floor(scene, 10.0 * whole.view_factor());
    EXPECT_NEAR(seen_above(scene, Vec3(0.2F, 0.5F, 0.1F)), 10.0, 1e-5);
    EXPECT_EQ(seen_above(scene, Vec3(1.5F, 0.5F, 0.1F)), 0.0);
    EXPECT_EQ(PathTracer(scene, workers()).warnings().size(), 1U);
  }
}

// A sign with holes: where it is not, the lamp behind it in the same plane is seen, and lights.
TEST(CoincidentSurfacesTest, WhereAMaskLeavesNothingTheOtherIsSeen) {
  Scene scene = floor_scene({lamp(Rgb(4.0F), true), lamp(Rgb(10.0F), true)});
  scene.materials[1].alpha_mode = AlphaMode::mask;
  scene.materials[1].base_color_texture.texture = 0;
  scene.textures.emplace_back(2, 1, std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 0, 0}, true,
                              Wrap::clamp_to_edge, Wrap::clamp_to_edge);
  scene.meshes.push_back(whole.mesh(1));
  scene.meshes.push_back(whole.mesh(2));
  expect_floor(scene, 0.5 * (4.0 + 10.0) * whole.view_factor());
  EXPECT_NEAR(seen_above(scene, Vec3(-0.6F, 0.5F, 0.1F)), 4.0, 1e-5);
  EXPECT_NEAR(seen_above(scene, Vec3(0.5F, 0.5F, 0.1F)), 10.0, 1e-5);
}

}  // namespace
}  // namespace foveola
