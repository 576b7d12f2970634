#include "renderer/stability/estimate.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "renderer/base/random.h"
#include "renderer/stability/shapes.h"

namespace foveola {
namespace {

using ::testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(EstimateTest, StandardErrorIsThatOfTheBatches) {
  const RadianceEstimate estimate =
      mean_of_batches({DVec3(1, 2, 5), DVec3(2, 2, 5), DVec3(3, 8, 5)});
  EXPECT_EQ(estimate.mean, DVec3(2, 4, 5));
  EXPECT_NEAR(estimate.standard_error.x, std::sqrt(1.0 / 3.0), 1e-12);
  EXPECT_NEAR(estimate.standard_error.y, std::sqrt(12.0 / 3.0), 1e-12);
  EXPECT_EQ(estimate.standard_error.z, 0.0);
}

TEST(EstimateTest, DeviationIsJudgedByNoiseAndTolerance) {
  const RadianceEstimate estimate{
      .mean = DVec3(1.0, 2.002, 3.0), .standard_error = DVec3(0.001), .samples = 100};
  const DVec3 expected(1.0, 2.0, 3.0);
  const StabilityFigure accepted = deviation("green", estimate, expected, 0.0, 0.01);
  EXPECT_EQ(accepted.name, "green");
  EXPECT_NEAR(accepted.measured, 0.1, 1e-9);
  EXPECT_NEAR(accepted.bound, 0.25, 1e-9);
  EXPECT_TRUE(accepted.passes());
  EXPECT_FALSE(deviation("", estimate, expected, 0.0, 0.0005).passes());
  EXPECT_TRUE(deviation("", estimate, expected, 0.0006, 0.0005).passes());
  const RadianceEstimate precise{.mean = estimate.mean, .standard_error = DVec3(1e-5)};
  EXPECT_FALSE(deviation("", precise, expected, 0.0, 0.01).passes());
}

TEST(EstimateTest, ExcessForgivesWhatIsBelowTheLimit) {
  RadianceEstimate estimate{.mean = DVec3(0.5, 0.9, 0.7), .standard_error = DVec3(0.001)};
  EXPECT_EQ(excess("", estimate, 1.0, 0.0, 0.01).measured, 0.0);
  estimate.mean.b = 1.004;
  EXPECT_TRUE(excess("", estimate, 1.0, 0.0, 0.01).passes());
  estimate.mean.b = 1.006;
  EXPECT_FALSE(excess("", estimate, 1.0, 0.0, 0.01).passes());
}

TEST(EstimateTest, WhatIsNotANumberFails) {
  for (int channel = 0; channel < 3; ++channel) {
    RadianceEstimate estimate{.mean = DVec3(1.0), .standard_error = DVec3(0.1)};
    estimate.mean[channel] = nan;
    EXPECT_FALSE(deviation("", estimate, DVec3(1.0), 1.0, 1.0).passes());
    EXPECT_FALSE(excess("", estimate, 2.0, 1.0, 1.0).passes());
  }
  const std::vector<StabilityFigure> figures{{.name = "bad", .measured = nan, .bound = 1.0},
                                             {.name = "worse", .measured = 9.0, .bound = 1.0}};
  EXPECT_FALSE(worst_of("all", figures).passes());
}

TEST(EstimateTest, WorstIsClosestToItsBound) {
  const std::vector<StabilityFigure> figures{{.name = "a", .measured = 5.0, .bound = 10.0},
                                             {.name = "b", .measured = 0.9, .bound = 1.0},
                                             {.name = "c", .measured = 0.0, .bound = 0.0}};
  const StabilityFigure worst = worst_of("all", figures);
  EXPECT_EQ(worst.name, "all");
  EXPECT_EQ(worst.measured, 0.9);
  EXPECT_THAT(worst.details, HasSubstr("worst of 3: b"));
}

/// A matte floor under a sky that is seen too: the mean of both.
TEST(EstimateTest, MeasuresUntilItIsPreciseEnough) {
  Scene scene;
  scene.materials = {matte(Rgb(0.5F))};
  scene.meshes = {quad(Vec3(-9, -1, 9), Vec3(18, 0, 0), Vec3(0, 0, -18), 0)};
  scene.environment = constant_environment(1.0F);
  const Workers workers(2);
  const PathTracer tracer(scene, workers);
  const Measurement bundle{
      .viewpoint = Vec3(0.0F),
      .direction = [](const Vec2& u) { return Vec3(0, u.x < 0.5F ? -1 : 1, 0); },
      .max_depth = 2,
      .expected = 0.75};
  StabilityRun run{.workers = workers, .effort = {.tolerance = 0.02, .most_samples = 1 << 20}};
  const RadianceEstimate estimate = measure(tracer, bundle, run);
  EXPECT_NEAR(estimate.mean.g, 0.75, 0.02 * 0.75);
  EXPECT_LE(5.0 * estimate.standard_error.g, 0.02 * 0.75);
  EXPECT_LT(estimate.samples, 1U << 20);
  run.effort.tolerance = 0.0;
  EXPECT_EQ(measure(tracer, bundle, run).samples, 1U << 20);
}

TEST(EstimateTest, StopsWhenRequested) {
  Scene scene;
  scene.materials = {matte(Rgb(0.5F))};
  scene.meshes = {quad(Vec3(-9, -1, 9), Vec3(18, 0, 0), Vec3(0, 0, -18), 0)};
  scene.environment = constant_environment(1.0F);
  const Workers workers(1);
  std::stop_source stop;
  stop.request_stop();
  const StabilityRun run{.workers = workers,
                         .effort = {.tolerance = 0.0, .most_samples = std::uint64_t{1} << 40},
                         .stop = stop.get_token()};
  const Measurement down = along(Vec3(0.0F), Vec3(0.3F, -1, 0), 2, 0.5);
  EXPECT_LE(measure(PathTracer(scene, workers), down, run).samples, 10000U);
}

}  // namespace
}  // namespace foveola
