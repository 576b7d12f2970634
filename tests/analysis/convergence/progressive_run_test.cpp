#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/convergence/measurement.h"
#include "renderer/preview/preview.h"
#include "tests/renderer/preview/box_room.h"

namespace foveola::analysis {
namespace {

class ProgressiveRunTest : public testing::Test {
 protected:
  ProgressiveRunTest() {
    plan_.size = {64, 32};
    plan_.max_depth = 3;
  }

  ProgressiveRun run(const std::string& method,
                     RandomNumbers numbers = RandomNumbers::low_discrepancy,
                     std::uint32_t seed = 7) const {
    return {subject_, plan_, {.name = method, .method = method, .render = {.numbers = numbers}},
            aim_,     seed,  workers_};
  }

  /// Mean over pixels of the squared distance between two renders with different seeds.
  double squared_difference(RandomNumbers numbers, std::uint64_t samples) const {
    ProgressiveRun a = run("od", numbers, 1);
    ProgressiveRun b = run("od", numbers, 2);
    a.advance(samples);
    b.advance(samples);
    double sum = 0.0;
    for (int y = 0; y < plan_.size.y; ++y) {
      for (int x = 0; x < plan_.size.x; ++x) {
        const double d = a.film().mean(x, y).g - b.film().mean(x, y).g;
        sum += d * d;
      }
    }
    return sum / (plan_.size.x * plan_.size.y);
  }

  Rgb mean(const EquirectFilm& film) const {
    DVec3 sum(0.0);
    for (const Rgb& pixel : film.resolve().color.pixels) {
      sum += DVec3(pixel);
    }
    return Rgb(sum / static_cast<double>(plan_.size.x * plan_.size.y));
  }

  PreviewSettings preview_settings() const {
    PreviewSettings settings;
    settings.render.film_size = plan_.size;
    settings.render.trace.max_depth = plan_.max_depth;
    return settings;
  }

  Workers workers_{2};
  LoadedScene loaded_{{.name = "box", .camera_position = Vec3(0.0F)}, box_room(0.5F), workers_};
  Subject subject_{.loaded = loaded_, .key = "box"};
  ConvergencePlan plan_;
  AzimuthElevation gaze_{.azimuth_rad = 0.7, .elevation_rad = 0.1};
  Aim aim_{.viewport = Viewport(head_orientation(gaze_), radians(100.0), radians(100.0)),
           .gaze = direction_from(gaze_)};
};

// Benchmarks run what is shipped: the preview gives the same picture, to the bit.
TEST_F(ProgressiveRunTest, IsWhatThePreviewRenders) {
  const PreviewSettings settings = preview_settings();
  ScriptedHeadTracker head({{.time = Nanoseconds(0), .heading = gaze_}});
  FixedEyeTracker eye(Vec3(0.0F, 0.0F, -1.0F));
  Preview preview(loaded_.tracer, settings, eye, head, workers_);
  for (const std::string method : {"od", "vp"}) {
    preview.restart(method, 7);
    preview.render_frame(Nanoseconds(0), 20'000);
    ProgressiveRun progressive = run(method);
    progressive.advance(5'000);
    progressive.advance(15'000);
    for (int y = 0; y < plan_.size.y; ++y) {
      for (int x = 0; x < plan_.size.x; ++x) {
        ASSERT_EQ(progressive.film().mean(x, y), preview.film().mean(x, y)) << method;
      }
    }
  }
}

TEST_F(ProgressiveRunTest, IsAdaptiveAsThePreviewIs) {
  constexpr double contrast = 0.3;
  constexpr std::uint64_t batch = 1 << 16;
  PreviewSettings settings = preview_settings();
  settings.render.adaptive = VisibleNoise{.contrast = contrast};
  ScriptedHeadTracker head({{.time = Nanoseconds(0), .heading = gaze_}});
  FixedEyeTracker eye(Vec3(0.0F, 0.0F, -1.0F));
  Preview preview(loaded_.tracer, settings, eye, head, workers_);
  preview.restart("od", 7);
  preview.render_frame(Nanoseconds(0), batch);
  preview.render_frame(Nanoseconds(0), batch);
  ProgressiveRun adaptive(
      subject_, plan_,
      {.name = "od", .method = "od", .render = {.adaptive = VisibleNoise{.contrast = contrast}}},
      aim_, 7, workers_);
  adaptive.advance(2 * batch);
  EXPECT_LT(adaptive.film().total_samples(), 2 * batch);
  EXPECT_EQ(adaptive.film().resolve().color.pixels, preview.film().resolve().color.pixels);
}

TEST_F(ProgressiveRunTest, CutsSamples) {
  ProgressiveRun cut(
      subject_, plan_,
      {.name = "od", .method = "od", .render = {.trace = {.largest_radiance = 0.6F}}}, aim_, 7,
      workers_);
  cut.advance(10'000);
  float largest = 0.0F;
  for (const Rgb& pixel : cut.film().resolve().color.pixels) {
    largest = std::max(largest, max_component(pixel));
  }
  EXPECT_EQ(largest, 0.6F);
}

// Other numbers, but no other picture.
TEST_F(ProgressiveRunTest, WaysOfTracingShowTheSame) {
  constexpr std::uint64_t samples = 100'000;
  ProgressiveRun usual = run("od");
  usual.advance(samples);
  const Rgb expected = mean(usual.film());
  const std::vector<Configuration> configurations =
      make_configurations({"od"}, {"no-fast-path", "no-hierarchy", "uniform-lights", "area-lights",
                                   "no-mis", "no-roulette", "plain-paths", "plain-paths-mis"});
  subject_.add_tracers_for(configurations, workers_);
  for (const Configuration& configuration :
       std::span(configurations).subspan(1)) {  // without the usual one
    ProgressiveRun changed(subject_, plan_, configuration, aim_, 7, workers_);
    changed.advance(samples);
    EXPECT_NE(changed.film().resolve().color.pixels, usual.film().resolve().color.pixels)
        << configuration.name;
    EXPECT_NEAR(mean(changed.film()).g, expected.g, 0.01F * expected.g) << configuration.name;
  }
}

// Three stops brighter, eight times as much is shown as white.
TEST_F(ProgressiveRunTest, CutsLightSamplesAsTheDisplayShowsThem) {
  const auto lightness = [&](float largest, double exposure_stops) {
    loaded_.source.exposure_stops = exposure_stops;
    ProgressiveRun cut(
        subject_, plan_,
        {.name = "od", .method = "od", .render = {.trace = {.largest_light_sample = largest}}},
        aim_, 7, workers_);
    cut.advance(20'000);
    return mean(cut.film()).g;
  };
  const float uncut = lightness(1e30F, 0.0);
  const float cut = lightness(0.1F, 0.0);
  EXPECT_LT(cut, 0.98F * uncut);
  EXPECT_EQ(lightness(0.8F, 3.0), cut);
}

TEST_F(ProgressiveRunTest, CountsItsSamples) {
  for (const RandomNumbers numbers : {RandomNumbers::low_discrepancy, RandomNumbers::independent}) {
    ProgressiveRun progressive = run("fv", numbers);
    progressive.advance(1'000);
    progressive.advance(2'345);
    EXPECT_EQ(progressive.samples(), 3'345U);
    EXPECT_EQ(progressive.film().total_samples(), 3'345U);
    EXPECT_EQ(progressive.dropped(), 0U);
    EXPECT_GT(progressive.seconds(), 0.0);
  }
}

// Counts of independent samples are binomial: their variance is their mean, where a sequence's are
// all but equal.
TEST_F(ProgressiveRunTest, IndependentDirectionsClumpLikeChance) {
  constexpr double per_pixel = 16.0;
  ProgressiveRun progressive = run("od", RandomNumbers::independent);
  progressive.advance(static_cast<std::uint64_t>(per_pixel) * 64 * 32);
  double variance = 0.0;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double d = progressive.film().sample_count(x, y) - per_pixel;
      variance += d * d / (64.0 * 32.0);
    }
  }
  // The variance of 2048 counts has a relative standard error of sqrt(2 / 2048).
  EXPECT_NEAR(variance / per_pixel, 1.0, 4.0 * std::sqrt(2.0 / 2048.0));
}

// Independent samples' squared error falls as 1 / n; a sequence's is smaller.
TEST_F(ProgressiveRunTest, IndependentPathsConvergeLikeChance) {
  constexpr std::uint64_t few = 16 * 64 * 32;
  constexpr std::uint64_t many = 8 * few;
  const double fall = squared_difference(RandomNumbers::independent, few) /
                      squared_difference(RandomNumbers::independent, many);
  // A binomial count n has the mean reciprocal (1 + 1 / mean n) / mean n, to the next order.
  EXPECT_NEAR(fall, 8.0 * (1.0 + 1.0 / 16.0) / (1.0 + 1.0 / 128.0), 1.5);
  EXPECT_LT(squared_difference(RandomNumbers::low_discrepancy, many),
            0.6 * squared_difference(RandomNumbers::independent, many));
}

TEST_F(ProgressiveRunTest, IndependentNumbersDoNotDependOnThreads) {
  const Workers one(1);
  ProgressiveRun alone(
      subject_, plan_,
      {.name = "od", .method = "od", .render = {.numbers = RandomNumbers::independent}}, aim_, 7,
      one);
  ProgressiveRun two = run("od", RandomNumbers::independent);
  alone.advance(20'000);
  two.advance(20'000);
  EXPECT_EQ(alone.film().resolve().color.pixels, two.film().resolve().color.pixels);
}

}  // namespace
}  // namespace foveola::analysis
