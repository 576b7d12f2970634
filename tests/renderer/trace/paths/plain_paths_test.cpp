// Plainer ways of tracing, which are there to be measured, show the same as the usual one.
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/stability/furnished_room.h"
#include "tests/renderer/trace/paths.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

constexpr LightSampling plain_lights{
    .selection = LightSelection::uniform, .triangles_by_area = true, .environment_by_cosine = true};

/// A way of tracing that is not the usual one.
struct Way {
  std::string name;
  LightSampling lights;
  TraceSettings settings;
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

const std::vector<Way>& ways() {
  static const std::vector<Way> all = {
      {"Uniform", {.selection = LightSelection::uniform}, {}},
      {"ByArea", {.triangles_by_area = true}, {}},
      {"CosineSky", {.environment_by_cosine = true}, {}},
      {"LightSamplesAlone", {}, {.light_samples_alone = true}},
      {"NoRoulette", {}, {.vertices_before_roulette = no_roulette}},
      {"PlainWithMis", plain_lights, {.vertices_before_roulette = no_roulette}},
      {"Plain",
       plain_lights,
       {.vertices_before_roulette = no_roulette, .light_samples_alone = true}}};
  return all;
}

std::vector<Rgb> radiance_of(const PathTracer& tracer, const Vec3& viewpoint,
                             const std::vector<SampleJob>& jobs, TraceSettings settings) {
  settings.max_depth = 4;
  settings.seed = 1;
  std::vector<Rgb> radiance(jobs.size());
  tracer.trace(viewpoint, jobs, radiance, settings, workers());
  return radiance;
}

/// Both means of a scene's radiance along the same directions, whose differences have less noise
/// than either. They agree within five standard errors, which are at most one per cent of the mean.
void expect_same(const Scene& scene, const Vec3& viewpoint, const Way& way) {
  const std::vector<SampleJob> jobs = jobs_all_around(150'000);
  const std::vector<Rgb> usual = radiance_of(PathTracer(scene, workers()), viewpoint, jobs, {});
  const std::vector<Rgb> other =
      radiance_of(PathTracer(scene, workers(), way.lights), viewpoint, jobs, way.settings);
  MeanEstimate difference;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    difference.add(other[i].g - usual[i].g);
  }
  const double mean = mean_of(usual).mean();
  EXPECT_NE(other, usual);
  EXPECT_LT(difference.standard_error(), 0.01 * mean);
  EXPECT_NEAR(difference.mean(), 0.0, 5.0 * difference.standard_error());
}

class PlainPathsTest : public testing::TestWithParam<Way> {};

INSTANTIATE_TEST_SUITE_P(Ways, PlainPathsTest, testing::ValuesIn(ways()),
                         [](const auto& way) { return way.param.name; });

/// The room of everything, in which a cube takes the place of the lamp of 1280 triangles in the
/// tinted glass: of as many lights, a uniform selection would hardly ever draw the others.
Scene room_of_few_lights() {
  Scene scene = room_of_everything();
  for (Mesh& mesh : scene.meshes) {
    if (scene.materials[static_cast<std::size_t>(mesh.material)].emission == Rgb(20.0F)) {
      mesh = inside_out(inward_box(Vec3(-0.5F, 0.2F, -0.4F), 0.03F, mesh.material));
    }
  }
  return scene;
}

TEST_P(PlainPathsTest, ShowTheSameOfARoomOfEverything) {
  expect_same(room_of_few_lights(), room_viewpoint, GetParam());
}

/// A floor with a glossy ball under a sky that is bright in one place, two suns with a disc, a
/// large lamp near the floor, and a pane of rough thin glass that light comes through.
Scene yard() {
  Scene scene;
  Material pane = glass(0.5F);
  pane.is_solid = false;
  scene.materials = {dielectric(0.6F, 0.5F), metal(0.8F, 0.4F), emitter(3.0F, true), pane};
  scene.meshes = {
      quad(Vec3(-5, -1, 5), Vec3(10, 0, 0), Vec3(0, 0, -10), 0),
      placed(inside_out(inward_sphere(0.5F, 3, 1)), 1.0F, Quat(1, 0, 0, 0), Vec3(1.2F, -0.4F, -1)),
      quad(Vec3(-1, -0.9F, -2), Vec3(0.1F, 0.4F, 0), Vec3(0, 0, 3), 2),
      quad(Vec3(0.6F, -1, 0.5F), Vec3(1.5F, 0, 0), Vec3(0, 1.2F, 0), 3)};
  Environment sky = constant_environment(1.0F);
  sky.map_width = 32;
  sky.map_height = 16;
  sky.map.assign(32 * 16, Rgb(0.4F));
  for (std::size_t y = 4; y < 7; ++y) {
    for (std::size_t x = 10; x < 14; ++x) {
      sky.map[y * 32 + x] = Rgb(6.0F);
    }
  }
  scene.environment = sky;
  const auto sun = [](const Vec3& direction, float irradiance) {
    return PunctualLight{.kind = PunctualLight::Kind::directional,
                         .direction = glm::normalize(direction),
                         .intensity = Rgb(irradiance),
                         .angular_radius_rad = 0.1F};
  };
  scene.lights = {sun({-1, -1, 0.3F}, 2.0F), sun({0.2F, -1, 1}, 0.5F)};
  return scene;
}

TEST_P(PlainPathsTest, ShowTheSameOfAYard) { expect_same(yard(), Vec3(0, 0.3F, 1), GetParam()); }

/// Unlit surfaces shine but no light sample is drawn from them: what scattered rays meet counts.
TEST_P(PlainPathsTest, SeeWhatNoLightSampleFinds) {
  Scene scene = furnished_room();
  scene.meshes.push_back(quad({-0.9F, 0.9F, 0.9F}, {0, 0, -0.2F}, {0.2F, 0, 0},
                              scene.meshes[6].material));  // a second lamp
  Material sign = matte(Rgb(0.9F));
  sign.unlit = true;
  scene.materials.push_back(sign);
  scene.meshes.push_back(quad(Vec3(-0.9F, -0.9F, -0.95F), Vec3(1.8F, 0, 0), Vec3(0, 1.8F, 0),
                              static_cast<int>(scene.materials.size()) - 1));
  if (GetParam().lights.environment_by_cosine) {
    scene.environment = constant_environment(0.1F);  // else it would change nothing
    scene.meshes.erase(scene.meshes.begin() + 1);    // the ceiling
  }
  expect_same(scene, room_viewpoint, GetParam());
}

/// A floor of albedo 0.8 under a sky of radiance 1, drawn by the cosine, is 0.8 in every sample:
/// what its scattered rays meet of the sky adds nothing. The camera and a mirror see the sky
/// itself.
TEST(LightSamplesAloneTest, CountWhatIsMetOnlyFromTheCameraAndFromMirrors) {
  Scene scene;
  scene.materials = {matte(Rgb(0.8F)), metal(1.0F, 0.0F)};
  scene.meshes = {quad(Vec3(-9, 0, 9), Vec3(18, 0, 0), Vec3(0, 0, -18), 0)};
  scene.environment = constant_environment(1.0F);
  const auto expect_every_sample = [&](const Vec3& direction, float expected) {
    const PathTracer tracer(scene, workers(), {.environment_by_cosine = true});
    for (const Rgb& value : radiance_of(tracer, Vec3(0.2F, 0.5F, 0.1F), jobs_along(direction, 200),
                                        {.light_samples_alone = true})) {
      EXPECT_NEAR(value.g, expected, 1e-5F);
    }
  };
  expect_every_sample(Vec3(0.1F, -1, 0), 0.8F);
  expect_every_sample(Vec3(0.1F, 1, 0), 1.0F);
  scene.meshes[0].material = 1;
  expect_every_sample(Vec3(0.1F, -1, 0), 1.0F);
}

/// A dim closed room of one colour: every path goes on to its last vertex.
TEST(NoRouletteTest, EndsNoPath) {
  Scene scene;
  scene.materials = {matte(Rgb(0.2F))};
  scene.materials[0].emission = Rgb(0.5F);
  scene.meshes = {inward_box(Vec3(0.0F), 1.0F, 0)};
  const PathTracer tracer(scene, workers());
  const std::vector<SampleJob> jobs = jobs_all_around(2000);
  std::vector<Rgb> radiance(jobs.size());
  const auto bounces = [&](bool general, int vertices_before_roulette) {
    return tracer
        .trace(Vec3(0.1F), jobs, radiance,
               {.max_depth = 5,
                .vertices_before_roulette = vertices_before_roulette,
                .uses_general_path = general},
               workers())
        .bounce;
  };
  for (const bool general : {false, true}) {
    EXPECT_EQ(bounces(general, no_roulette), 5U * jobs.size());
    EXPECT_EQ(bounces(general, 5), 5U * jobs.size());
    // With twice its throughput: 2 * 0.2^2 of all paths survive the second vertex, which gives them
    // a throughput of a half, and 2 * 0.5 * 0.2 of what is left each of the next ones.
    EXPECT_NEAR(static_cast<double>(bounces(general, 1)),
                2000.0 * (1.0 + 0.08 * (1.0 + 0.2 + 0.2 * 0.2 + 0.2 * 0.2 * 0.2)), 60.0);
  }
}

/// A point lamp gives a matte floor more than the limit in red, and less in the other channels.
TEST(LargestLightSampleTest, CutsWhatLightSamplesGiveAndNothingElse) {
  Scene scene;
  scene.materials = {matte(Rgb(0.5F)), emitter(50.0F)};
  scene.meshes = {quad(Vec3(-9, 0, 9), Vec3(18, 0, 0), Vec3(0, 0, -18), 0)};
  scene.lights = {{.position = Vec3(0, 2, 0),
                   .intensity = std::numbers::pi_v<float> * Rgb(80.0F, 8.0F, 16.0F)}};
  const auto floor_with = [&](float largest) {
    return radiance_of(PathTracer(scene, workers()), Vec3(0, 1, 0), jobs_along({0, -1, 0}, 1),
                       {.largest_light_sample = largest})
        .front();
  };
  const Rgb uncut = floor_with(1e30F);
  EXPECT_NEAR(uncut.r, 10.0F, 1e-4F);
  const Rgb cut = floor_with(3.0F);
  EXPECT_EQ(cut.r, 3.0F);
  EXPECT_NEAR(cut.g, 1.0F, 1e-5F);
  EXPECT_NEAR(cut.b, 2.0F, 1e-5F);
  scene.meshes[0].material = 1;
  EXPECT_EQ(floor_with(3.0F), Rgb(50.0F));
}

}  // namespace
}  // namespace foveola
