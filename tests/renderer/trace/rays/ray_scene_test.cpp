#include "renderer/trace/rays/ray_scene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <stop_token>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/clock.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/trace/surfaces/triangle.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/shadow_answers.h"

namespace foveola {
namespace {

using test::ask_blocked;
using test::ShadowAnswer;

const Workers& workers() {
  static const Workers four(4);
  return four;
}

Scene one_quad() {
  Scene scene;
  scene.materials = {dielectric(0.5F)};
  scene.meshes = {quad(Vec3(-1, -1, -3), Vec3(2, 0, 0), Vec3(0, 2, 0), 0)};
  return scene;
}

Ray ray_between(const Vec3& from, const Vec3& to) {
  Ray ray;
  ray.origin = from;
  ray.direction = to - from;
  ray.t_max = 1.0F;
  return ray;
}

auto count_blocked(const std::vector<ShadowAnswer>& answers) {
  return std::count_if(answers.begin(), answers.end(),
                       [](const ShadowAnswer& answer) { return answer.is_blocked; });
}

TEST(RaySceneTest, FindsTheClosestTriangleAndWhere) {
  Scene scene = one_quad();
  scene.meshes.push_back(quad(Vec3(-1, -1, -2), Vec3(2, 0, 0), Vec3(0, 2, 0), 0));
  const RayScene rays(scene, workers());
  const Hit hit = rays.closest_hit(Vec3(0.5F, -0.25F, 0.0F), Vec3(0, 0, -1));
  ASSERT_FALSE(hit.missed());
  EXPECT_EQ(hit.object, 1U);
  EXPECT_EQ(hit.triangle, 0U);
  EXPECT_FLOAT_EQ(hit.t, 2.0F);
  // The point is corner + 0.75 a + 0.375 b, on the triangle (corner, corner + a, corner + a + b).
  EXPECT_NEAR(hit.barycentric.x, 0.375, 1e-6);
  EXPECT_NEAR(hit.barycentric.y, 0.375, 1e-6);
}

/// Hills of 40 000 triangles.
Scene hills() {
  constexpr std::uint32_t side = 200;
  Scene scene;
  scene.materials = {dielectric(0.5F)};
  Mesh mesh;
  for (std::uint32_t i = 0; i <= side * (side + 1); ++i) {
    const auto x = static_cast<float>(i % (side + 1));
    const auto y = static_cast<float>(i / (side + 1));
    mesh.positions.emplace_back(x, y, std::sin(x) * std::cos(y));
  }
  for (std::uint32_t i = 0; i + side + 1 < mesh.positions.size(); ++i) {
    mesh.triangles.push_back({i, i + 1, i + side + 1});
  }
  scene.meshes = {mesh};
  return scene;
}

/// How often the build of `scene` reports its progress, if it is stopped at the first report or
/// not.
int build_reports(const Scene& scene, bool is_stopped) {
  std::stop_source stop;
  std::atomic<int> reports = 0;
  const WorkScope scope(stop.get_token(), [&](const char*, double fraction_done) {
    EXPECT_GE(fraction_done, 0.0);
    EXPECT_LE(fraction_done, 1.0);
    ++reports;
    if (is_stopped) {
      stop.request_stop();
    }
  });
  if (is_stopped) {
    EXPECT_THROW(RayScene(scene, workers()), WorkStopped);
  } else {
    EXPECT_FALSE(
        RayScene(scene, workers()).closest_hit(Vec3(9.25F, 9.25F, 9), Vec3(0, 0, -1)).missed());
  }
  return reports;
}

TEST(RaySceneTest, BuildingTellsItsProgressAndEndsWhenItIsStopped) {
  const Scene scene = hills();
  const int stopped = build_reports(scene, true);
  EXPECT_GT(stopped, 0);
  EXPECT_LT(stopped, build_reports(scene, false) / 2);
}

TEST(RaySceneTest, EmptySceneIsAlwaysMissed) {
  const Scene scene;
  const RayScene rays(scene, workers());
  EXPECT_TRUE(rays.closest_hit(Vec3(0.0F), Vec3(0, 0, -1)).missed());
  const std::vector<Ray> ray{ray_between(Vec3(0.0F), Vec3(1.0F))};
  EXPECT_FALSE(ask_blocked(rays, ray)[0].is_blocked);
}

TEST(RaySceneTest, MeshesWithoutTrianglesKeepTheNumbersOfTheOthers) {
  Scene scene = one_quad();
  scene.meshes.insert(scene.meshes.begin(), Mesh{});
  const Hit hit = RayScene(scene, workers()).closest_hit(Vec3(0.1F), Vec3(0, 0, -1));
  EXPECT_EQ(hit.object, 1U);
}

TEST(RaySceneTest, OcclusionKnowsWhereTheRayEnds) {
  const Scene scene = one_quad();
  const RayScene rays(scene, workers());
  const std::vector<Ray> some{ray_between(Vec3(0.0F), Vec3(0, 0, -2.9F)),
                              ray_between(Vec3(0.0F), Vec3(0, 0, -3.1F)),
                              ray_between(Vec3(3, 0, 0), Vec3(3, 0, -9))};
  const std::vector<ShadowAnswer> answers = ask_blocked(rays, some);
  EXPECT_FALSE(answers[0].is_blocked);
  EXPECT_TRUE(answers[1].is_blocked);
  EXPECT_FALSE(answers[2].is_blocked);
}

TEST(RaySceneTest, NonFiniteTrianglesAreNeverHit) {
  Scene scene = one_quad();
  scene.meshes[0].positions[0].x = NAN;
  EXPECT_TRUE(
      RayScene(scene, workers()).closest_hit(Vec3(0.5F, -0.5F, 0), Vec3(0, 0, -1)).missed());
}

/// A quad whose left half is transparent by its texture, before an opaque one.
Scene half_transparent() {
  Scene scene = one_quad();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].base_color_texture.texture = 0;
  scene.materials[1].alpha_mode = AlphaMode::mask;
  scene.textures.emplace_back(2, 1, std::vector<std::uint8_t>{255, 255, 255, 0, 255, 255, 255, 255},
                              true, Wrap::clamp_to_edge, Wrap::clamp_to_edge);
  scene.meshes.push_back(quad(Vec3(-1, -1, -2), Vec3(2, 0, 0), Vec3(0, 2, 0), 1));
  return scene;
}

TEST(RaySceneTest, RaysPassThroughCutOuts) {
  const Scene scene = half_transparent();
  const RayScene rays(scene, workers());
  EXPECT_EQ(rays.closest_hit(Vec3(-0.5F, 0.1F, 0), Vec3(0, 0, -1)).object, 0U);
  EXPECT_EQ(rays.closest_hit(Vec3(0.5F, 0.1F, 0), Vec3(0, 0, -1)).object, 1U);
  const std::vector<Ray> some{ray_between(Vec3(-0.5F, 0.1F, 0), Vec3(-0.5F, 0.1F, -2.5F)),
                              ray_between(Vec3(0.5F, 0.1F, 0), Vec3(0.5F, 0.1F, -2.5F))};
  const std::vector<ShadowAnswer> answers = ask_blocked(rays, some);
  EXPECT_FALSE(answers[0].is_blocked);
  EXPECT_TRUE(answers[1].is_blocked);
}

TEST(RaySceneTest, AlphaFactorMultipliesTheTexture) {
  Scene scene = half_transparent();
  scene.materials[1].alpha = 0.4F;
  const RayScene rays(scene, workers());
  EXPECT_EQ(rays.closest_hit(Vec3(0.5F, 0.1F, 0), Vec3(0, 0, -1)).object, 0U);
}

TEST(RaySceneTest, BlendedSurfacesAreMetAsOftenAsTheyAreOpaque) {
  Scene scene = one_quad();
  scene.materials[0].alpha = 0.3F;
  scene.materials[0].alpha_mode = AlphaMode::blend;
  const RayScene rays(scene, workers());
  constexpr int count = 40000;
  int met = 0;
  std::vector<Ray> many;
  for (std::uint32_t key = 0; key < count; ++key) {
    const Ray ray{.direction = Vec3(0.1F, 0.2F, -1.0F), .key = key};
    met += rays.closest_hit(ray).missed() ? 0 : 1;
    many.push_back(ray);
  }
  const auto blocked = count_blocked(ask_blocked(rays, many));
  const double five_errors = 5.0 * std::sqrt(count * 0.3 * 0.7);
  EXPECT_NEAR(met, 0.3 * count, five_errors);
  EXPECT_EQ(blocked, met) << "the same keys decide alike for both kinds of ray";
}

// Two sheets of 50 % must stop three quarters of the rays: their decisions are independent.
TEST(RaySceneTest, BlendedSurfacesInLineDecideApart) {
  Scene scene = one_quad();
  scene.materials[0].alpha = 0.5F;
  scene.materials[0].alpha_mode = AlphaMode::blend;
  scene.meshes.push_back(quad(Vec3(-1, -1, -2), Vec3(2, 0, 0), Vec3(0, 2, 0), 0));
  const RayScene rays(scene, workers());
  constexpr int count = 40000;
  std::vector<Ray> many;
  for (std::uint32_t key = 0; key < count; ++key) {
    many.push_back({.direction = Vec3(0.1F, 0.2F, -1.0F), .key = key});
  }
  const auto blocked = count_blocked(ask_blocked(rays, many));
  EXPECT_NEAR(static_cast<double>(blocked), 0.75 * count, 5.0 * std::sqrt(count * 0.75 * 0.25));
}

TEST(RaySceneTest, ThinSurfacesAreMetButDoNotBlock) {
  Scene scene = one_quad();
  scene.materials[0].transmission = 1.0F;
  scene.materials[0].roughness = 0.0F;
  const RayScene rays(scene, workers());
  EXPECT_FALSE(rays.closest_hit(Vec3(0.0F), Vec3(0.1F, 0.2F, -1.0F)).missed());
  const std::vector<Ray> some{{.direction = Vec3(0.1F, 0.2F, -1.0F)},
                              {.direction = Vec3(0.0F, 0.0F, 1.0F)}};
  const std::vector<ShadowAnswer> answers = ask_blocked(rays, some);
  EXPECT_FALSE(answers[0].is_blocked);
  EXPECT_TRUE(answers[0].met_thin_surface);
  EXPECT_FALSE(answers[1].is_blocked);
  EXPECT_FALSE(answers[1].met_thin_surface);
}

TEST(RaySceneTest, AKeptHierarchyIsOfItsSurfaceToo) {
  Scene scene = one_quad();
  scene.prototypes.swap(scene.meshes);
  scene.instances = {{.prototype = 0}};
  KeptHierarchies kept;
  const std::vector<Ray> ray{{.direction = Vec3(0.1F, 0.2F, -1.0F)}};
  EXPECT_TRUE(ask_blocked(RayScene(scene, workers(), &kept), ray)[0].is_blocked);
  scene.materials[0].transmission = 1.0F;
  scene.materials[0].roughness = 0.0F;
  EXPECT_FALSE(ask_blocked(RayScene(scene, workers(), &kept), ray)[0].is_blocked);
}

TEST(RaySceneTest, BehindAThinSurfaceTheRaysOwnKeysDecide) {
  Scene scene = one_quad();
  scene.materials[0].alpha_mode = AlphaMode::blend;
  scene.materials[0].alpha = 0.5F;
  Scene with_window = scene;
  with_window.materials.push_back(dielectric(0.5F));
  with_window.materials[1].transmission = 1.0F;
  with_window.materials[1].roughness = 0.0F;
  with_window.meshes.push_back(quad(Vec3(-1, -1, -2), Vec3(2, 0, 0), Vec3(0, 2, 0), 1));
  const RayScene bare(scene, workers());
  const RayScene glazed(with_window, workers());
  std::vector<Ray> many;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    many.push_back({.direction = Vec3(0.1F, 0.2F, -1.0F), .key = mix(i)});
  }
  const std::vector<ShadowAnswer> without = ask_blocked(bare, many);
  const std::vector<ShadowAnswer> through = ask_blocked(glazed, many);
  for (std::uint32_t i = 0; i < many.size(); ++i) {
    EXPECT_EQ(through[i].is_blocked, without[i].is_blocked);
    EXPECT_EQ(through[i].key, mix(i));
  }
}

TEST(RaySceneTest, InstancesAreMetWhereTheyStand) {
  Scene scene = one_quad();
  scene.prototypes.push_back(quad(Vec3(-1, -1, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), 0));
  for (const float z : {-1.0F, -2.0F}) {
    Mat4 world_from_local(0.5F);
    world_from_local[3] = Vec4(0.0F, z, z, 1.0F);
    scene.instances.push_back({.name = "pane", .world_from_local = world_from_local});
  }
  const RayScene rays(scene, workers());
  const Hit hit = rays.closest_hit(Vec3(0.25F, -2.1F, 0.0F), Vec3(0, 0, -1));
  EXPECT_EQ(hit.object, 2U) << "after one mesh, the second instance";
  EXPECT_FLOAT_EQ(hit.t, 2.0F);
  const Vec3 at = Triangle(scene, hit.object, hit.triangle).at(hit.barycentric);
  EXPECT_NEAR(glm::length(at - Vec3(0.25F, -2.1F, -2.0F)), 0.0, 1e-6);
  EXPECT_EQ(rays.closest_hit(Vec3(0.0F), Vec3(0, 0, -1)).object, 0U);
}

TEST(RaySceneTest, UntexturedMaterialBelowItsCutoffIsNotThere) {
  Scene scene = one_quad();
  scene.materials[0].alpha = 0.4F;
  scene.materials[0].alpha_mode = AlphaMode::mask;
  EXPECT_TRUE(RayScene(scene, workers()).closest_hit(Vec3(0.0F), Vec3(0, 0, -1)).missed());
}

/// Two coincident spheres and rays at their edges: every hit is a tie.
TEST(RaySceneTest, TiesDoNotDependOnTheThreadsThatBuilt) {
  Scene scene;
  scene.materials = {dielectric(0.5F)};
  scene.meshes = {inward_sphere(1.0F, 4, 0), inward_sphere(1.0F, 4, 0)};
  const RayScene built_by_one(scene, Workers(1));
  const RayScene built_by_four(scene, workers());
  for (const auto& triangle : scene.meshes[0].triangles) {
    const Vec3 edge =
        scene.meshes[0].positions[triangle[0]] + scene.meshes[0].positions[triangle[1]];
    const Hit a = built_by_one.closest_hit(Vec3(0.0F), edge);
    const Hit b = built_by_four.closest_hit(Vec3(0.0F), edge);
    EXPECT_EQ(a.object, b.object);
    EXPECT_EQ(a.triangle, b.triangle);
    EXPECT_EQ(a.t, b.t);
  }
}

/// Rays at the edges of a sphere's silhouette, which they only just hit or miss.
struct SilhouetteRays {
  Scene scene;
  std::vector<Ray> rays;

  SilhouetteRays() {
    scene.materials = {dielectric(0.5F)};
    scene.meshes = {inward_sphere(1.0F, 3, 0)};
    Pcg32 random(2);
    for (int i = 0; i < 4096; ++i) {
      const auto& triangle = scene.meshes[0].triangles[random.below(1280)];
      rays.push_back(ray_between(Vec3(3, 0, 0), 2.0F * scene.meshes[0].positions[triangle[0]]));
    }
  }
};

TEST(RaySceneTest, OcclusionDoesNotDependOnTheOtherRays) {
  const SilhouetteRays silhouette;
  const RayScene rays(silhouette.scene, workers());
  const std::vector<ShadowAnswer> together = ask_blocked(rays, silhouette.rays);
  for (std::size_t i = 0; i < silhouette.rays.size(); ++i) {
    EXPECT_EQ(ask_blocked(rays, {&silhouette.rays[i], 1})[0].is_blocked, together[i].is_blocked)
        << i;
  }
}

HitQueries asked_of_eight(const RayScene& scene, std::span<const Ray> rays, std::uint32_t lanes) {
  Vec3Lanes origin{};
  Vec3Lanes direction{};
  for_each_lane(lanes, [&](std::size_t lane) {
    origin.put(lane, rays[lane].origin);
    direction.put(lane, rays[lane].direction);
  });
  HitQueries queries({origin.load(), direction.load(), Uints{}});
  scene.find_hits(queries, mask_of(lanes));
  return queries;
}

TEST(RaySceneTest, HitsDoNotDependOnTheOtherRays) {
  const SilhouetteRays silhouette;
  const RayScene scene(silhouette.scene, workers());
  const std::span<const Ray> rays(silhouette.rays);
  for (std::size_t first = 0; first < rays.size(); first += lane_count) {
    const auto eight = rays.subspan(first, lane_count);
    const HitQueries together = asked_of_eight(scene, eight, 0xffU);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const HitQueries alone = asked_of_eight(scene, eight, 1U << lane);
      EXPECT_EQ(alone.object()[lane], together.object()[lane]);
      if (alone.object()[lane] != Hit::nothing) {
        EXPECT_EQ(alone.triangle[lane], together.triangle[lane]);
        EXPECT_EQ(alone.rays.t_max[lane], together.rays.t_max[lane]);
        EXPECT_EQ(alone.u[lane], together.u[lane]);
        EXPECT_EQ(alone.v[lane], together.v[lane]);
      }
    }
  }
}

TEST(RaySceneTest, RaysThatAreNotAskedForStayAsTheyAre) {
  const Scene scene = one_quad();
  const RayScene rays(scene, workers());
  const std::vector<Ray> eight(lane_count, ray_between(Vec3(0.1F), Vec3(0.1F, 0.1F, -9.0F)));
  const HitQueries queries = asked_of_eight(rays, eight, 0b1010U);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    EXPECT_EQ(queries.object()[lane], lane == 1 || lane == 3 ? 0U : Hit::nothing);
  }
}

TEST(RaySceneTest, KnowsTheMemoryOfItsHierarchy) {
  const Workers workers(1);
  const auto bytes_of = [&](std::size_t triangles) {
    Scene scene;
    scene.materials.emplace_back();
    Mesh& mesh = scene.meshes.emplace_back();
    for (std::size_t i = 0; i < triangles; ++i) {
      const auto x = static_cast<float>(i);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return RayScene(scene, workers).memory_bytes();
  };
  // A leaf holds at least a triangle's three vertices, beside the copy of them.
  constexpr std::size_t triangles = 20'000;
  const std::size_t added = bytes_of(2 * triangles) - bytes_of(triangles);
  EXPECT_GT(added, triangles * 2 * 3 * sizeof(Vec3));
  EXPECT_LT(added, triangles * 1000);
}

}  // namespace
}  // namespace foveola
