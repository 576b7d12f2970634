// What is learned about lights from paths, and that it changes no picture.
#include "renderer/trace/lights/learned_lights.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/stability/furnished_room.h"
#include "renderer/trace/lights/lights.h"
#include "tests/renderer/trace/light_outcomes.h"
#include "tests/renderer/trace/paths.h"
#include "tests/renderer/trace/scenes.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

using test::every_light;
using test::learn_two_sides;
using test::random_shading_point;

/// The part of the samples at places of this x that are drawn from the environment.
double share_of_environment(const Lights& lights, float x) {
  Pcg32 random(4);
  int environment = 0;
  constexpr int draws = 1000;
  for (int i = 0; i < draws; ++i) {
    ShadingPoint point = random_shading_point(random, 1.0F);
    point.position.x = x;
    point.region = lights.region_of(point.position, point.normal);
    const float u_kind = unit_float(random.next());
    const LightOutcome outcome = lights.outcome(point, u_kind, Vec2(0.5F), Vec2(0.5F));
    environment += outcome.kind == LightKind::environment ? 1 : 0;
  }
  return static_cast<double>(environment) / draws;
}

TEST(LearnedLightsTest, KindsThatDoNotArriveAreDrawnLess) {
  const Scene scene = every_light();
  const Lights usual(scene, {}, 0);
  Lights lights(scene, {}, 0);
  learn_two_sides(lights);
  EXPECT_GT(share_of_environment(lights, 1.0F), 1.3 * share_of_environment(usual, 1.0F));
  EXPECT_LT(share_of_environment(lights, -1.0F), 0.75 * share_of_environment(usual, -1.0F));
}

/// Every light's samples have the density that rays are told of it, but for directions next to the
/// border of a square.
TEST(LearnedLightsTest, SamplesHaveTheDensityThatRaysAreTold) {
  Scene scene = every_light();
  scene.lights.resize(2);  // a disc of a sun has a density of its own
  Lights lights(scene, {}, 0);
  learn_two_sides(lights);
  Pcg32 random(6);
  int distant = 0;
  int otherwise = 0;
  double difference_from_usual = 0.0;
  const Lights usual(scene, {}, 0);
  for (int i = 0; i < 20'000; ++i) {
    ShadingPoint point = random_shading_point(random, 2.0F);
    point.region = lights.region_of(point.position, point.normal);
    const auto sample = lights.sample(point, unit_float(random.next()), test::unit_square(random),
                                      test::unit_square(random));
    if (!sample || sample->is_delta || std::isfinite(sample->t_max)) {
      continue;
    }
    ++distant;
    const float told = lights.distant_light(point, sample->direction).pdf;
    otherwise += std::abs(told - sample->pdf) > 1e-4F * sample->pdf ? 1 : 0;
    point.region = 0;
    difference_from_usual +=
        std::abs(std::log(told / usual.distant_light(point, sample->direction).pdf));
  }
  EXPECT_GT(distant, 1000);
  EXPECT_LT(otherwise, 0.002 * distant);
  EXPECT_GT(difference_from_usual / distant, 0.2);
}

TEST(LearnedLightsTest, NothingIsLearnedWhereItWouldNotHelp) {
  const Scene scene = every_light();
  const Lights usual(scene, {}, 0);
  Lights lights(scene, {}, 0);
  std::vector<LightOutcome> outcomes = test::outcomes_of(lights, 20'000);
  for (LightOutcome& outcome : outcomes) {
    outcome.gain =
        outcome.kind == LightKind::local && outcome.light == LightOutcome::no_light ? 0.0F : 1.0F;
  }
  lights.learn(outcomes);
  Pcg32 random(3);
  for (int i = 0; i < 100; ++i) {
    ShadingPoint point = random_shading_point(random, 2.0F);
    point.region = lights.region_of(point.position, point.normal);
    EXPECT_EQ(point.region, 0U);
    const Vec3 direction = glm::normalize(test::in_cube(random));
    EXPECT_EQ(lights.distant_light(point, direction).pdf,
              usual.distant_light(point, direction).pdf);
  }
}

/// Nothing of the sky arrives in the only region, and all of the suns: they are drawn 0.1 * 0.5 +
/// 0.9 of the time, where they were half of it.
TEST(LearnedLightsTest, RelativeMeanSquareIsByTheProbabilities) {
  std::vector<LightOutcome> outcomes;
  for (int i = 0; i < 50; ++i) {
    outcomes.push_back({.kind = LightKind::suns, .light = LightOutcome::no_light, .gain = 2.0F});
    outcomes.push_back({.kind = LightKind::environment, .light = 3});
  }
  const KindProbabilities usual{.environment = 0.5F, .suns = 0.5F};
  const LearnedLights learned(outcomes, usual, nullptr, /*knows_sky=*/true);
  EXPECT_FLOAT_EQ(learned.kinds(0).suns, 0.95F);
  EXPECT_FLOAT_EQ(learned.kinds(0).environment, 0.05F);
  EXPECT_NEAR(learned.relative_mean_square(outcomes, usual, nullptr), 0.5 / 0.95, 1e-6);
  EXPECT_EQ(learned.relative_mean_square({}, usual, nullptr), 1.0);
}

/// A hall under a roof with a gap at one end. Above the roof are 24 lamps, and below it three; the
/// sky and the sun are seen through the gap.
Scene hall() {
  Scene scene;
  scene.materials = {matte(Rgb(0.7F)), emitter(6.0F, true)};
  scene.meshes = {quad(Vec3(-4, 0, 4), Vec3(8, 0, 0), Vec3(0, 0, -8), 0),
                  quad(Vec3(-4, 2, 4), Vec3(6, 0, 0), Vec3(0, 0, -8), 0),
                  quad(Vec3(-4, 0, -4), Vec3(8, 0, 0), Vec3(0, 2, 0), 0),
                  quad(Vec3(-4, 0, 4), Vec3(0, 0, -8), Vec3(0, 2, 0), 0)};
  for (int i = 0; i < 27; ++i) {
    const auto x = static_cast<float>(i % 3 - 2);
    const auto z = static_cast<float>(i / 3 % 3 - 1);
    const float height = i < 3 ? 1.5F : 3.0F + static_cast<float>(i / 9);
    scene.meshes.push_back(quad(Vec3(x, height, z), Vec3(0.2F, 0, 0), Vec3(0, 0, 0.2F), 1));
  }
  Environment sky = constant_environment(1.0F);
  sky.map_width = 32;
  sky.map_height = 16;
  sky.map.assign(32 * 16, Rgb(0.5F));
  sky.map[5 * 32 + 20] = Rgb(30.0F);
  scene.environment = sky;
  scene.lights = {{.kind = PunctualLight::Kind::directional,
                   .direction = glm::normalize(Vec3(-0.5F, -1, 0.3F)),
                   .intensity = Rgb(2.0F)}};
  return scene;
}

constexpr Vec3 hall_viewpoint(0.5F, 1.0F, 0.5F);

/// The learned picture has the same mean along the same directions, and less variance.
void expect_less_noise(const Scene& scene, const Vec3& learned_at, const Vec3& viewpoint,
                       double factor) {
  const std::vector<SampleJob> jobs = jobs_all_around(200'000);
  PathTracer tracer(scene, workers());
  const std::vector<Rgb> usual = trace(tracer, viewpoint, jobs, 4);
  tracer.learn_lights(learned_at, workers());
  const std::vector<Rgb> learned = trace(tracer, viewpoint, jobs, 4);
  MeanEstimate difference;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    difference.add(learned[i].g - usual[i].g);
  }
  EXPECT_LT(difference.standard_error(), 0.02 * mean_of(usual).mean());
  EXPECT_NEAR(difference.mean(), 0.0, 5.0 * difference.standard_error());
  EXPECT_LT(mean_of(learned).standard_error(), factor * mean_of(usual).standard_error());
}

TEST(LearnedLightsTest, AHallIsLessNoisyAndTheSame) {
  expect_less_noise(hall(), hall_viewpoint, hall_viewpoint, 0.9);
}

TEST(LearnedLightsTest, AHallIsTheSameFromWhereNothingWasLearned) {
  expect_less_noise(hall(), hall_viewpoint, Vec3(0, 5, 0), 3.0);
}

TEST(LearnedLightsTest, ARoomOfEverythingIsTheSame) {
  expect_less_noise(room_of_everything(), room_viewpoint, room_viewpoint, 1.2);
}

TEST(LearnedLightsTest, WhatIsLearnedDoesNotDependOnThreads) {
  const Scene scene = hall();
  const std::vector<SampleJob> jobs = jobs_all_around(3000);
  PathTracer first(scene, workers());
  PathTracer second(scene, workers());
  first.learn_lights(hall_viewpoint, Workers(1));
  second.learn_lights(hall_viewpoint, Workers(3));
  EXPECT_EQ(trace(first, hall_viewpoint, jobs, 4), trace(second, hall_viewpoint, jobs, 4));
  EXPECT_NE(trace(first, hall_viewpoint, jobs, 4),
            trace(PathTracer(scene, workers()), hall_viewpoint, jobs, 4));
}

TEST(LearnedLightsTest, ReplayedPathsAreThoseTraced) {
  const Scene scene = hall();
  const std::vector<SampleJob> jobs = jobs_all_around(200);
  PathTracer tracer(scene, workers());
  tracer.learn_lights(hall_viewpoint, workers());
  const std::vector<Rgb> traced = trace(tracer, hall_viewpoint, jobs, 4);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_EQ(tracer.replay(hall_viewpoint, jobs[i], {.max_depth = 4, .seed = 1}).radiance,
              traced[i]);
  }
}

TEST(LearnedLightsTest, ASceneThatIsNeverMetIsNoError) {
  Scene scene;
  scene.materials = {matte(Rgb(0.5F))};
  scene.meshes = {quad(Vec3(1e6F, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1), 0)};
  scene.environment = constant_environment(1.0F);
  PathTracer tracer(scene, workers());
  tracer.learn_lights(Vec3(0.0F), workers());
  EXPECT_EQ(trace(tracer, Vec3(0.0F), jobs_along({0, 1, 0}, 1), 4)[0], Rgb(1.0F));
}

}  // namespace
}  // namespace foveola
