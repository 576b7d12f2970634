#include "renderer/preview/preview.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/measure/reference.h"
#include "renderer/view/equirect.h"
#include "renderer/view/radial_distribution.h"
#include "tests/matchers.h"
#include "tests/renderer/preview/box_room.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

constexpr Nanoseconds preview_frame_time = std::chrono::milliseconds(20);

double turned_deg(const Vec3& a, const Vec3& b) { return degrees(angle_between(a, b)); }

PreviewSettings small_settings() {
  PreviewSettings settings;
  settings.render.film_size = {256, 128};
  settings.view_size = {64, 48};
  settings.render.trace.max_depth = 3;
  return settings;
}

class PreviewTest : public testing::Test {
 protected:
  Scene scene_ = box_room(0.2F);
  Workers workers_{2};
  PathTracer tracer_{scene_, workers_};
  FixedEyeTracker ahead_{Vec3(0.0F, 0.0F, -1.0F)};
  ScriptedHeadTracker still_{{{.time = Nanoseconds(0), .heading = {}}}};
};

/// The share of the film's samples in pixels whose centres `is_inside`.
template <typename Predicate>
double share_of_samples(const EquirectFilm& film, const Predicate& is_inside) {
  std::uint64_t inside = 0;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const Vec2 center((static_cast<float>(x) + 0.5F) / static_cast<float>(film.width()),
                        (static_cast<float>(y) + 0.5F) / static_cast<float>(film.height()));
      if (is_inside(direction_from_equirect(center))) {
        inside += film.sample_count(x, y);
      }
    }
  }
  return static_cast<double>(inside) / static_cast<double>(film.total_samples());
}

TEST_F(PreviewTest, CountsFramesAndSamples) {
  Preview preview(tracer_, small_settings(), ahead_, still_, workers_);
  preview.restart("od", 1);
  for (std::uint64_t i = 0; i < 3; ++i) {
    const Nanoseconds now = preview_frame_time * i;
    const FrameReport report = preview.render_frame(now, 1000 + i);
    EXPECT_EQ(report.frame, i);
    EXPECT_EQ(report.time, now);
    EXPECT_EQ(report.samples, 1000 + i);
    EXPECT_GT(report.rays, 1000U);
  }
  EXPECT_EQ(preview.film().total_samples(), 3003U);
  EXPECT_TRUE(preview.dropped().empty());
}

TEST_F(PreviewTest, StandsElsewhereAsIfItHadBeenThereFromTheStart) {
  const Vec3 elsewhere(0.5F, 0.25F, -0.5F);
  Preview moved(tracer_, small_settings(), ahead_, still_, workers_);
  moved.restart("fv", 7);
  moved.render_frame(Nanoseconds(0), 2000);
  moved.stand_at(elsewhere);
  EXPECT_EQ(moved.film().total_samples(), 0U);
  EXPECT_EQ(moved.render_frame(Nanoseconds(0), 2000).frame, 0U);

  PreviewSettings settings = small_settings();
  settings.render.viewpoint = elsewhere;
  Preview there(tracer_, settings, ahead_, still_, workers_);
  there.restart("fv", 7);
  there.render_frame(Nanoseconds(0), 2000);
  EXPECT_EQ(moved.film().resolve().color.pixels, there.film().resolve().color.pixels);
}

TEST_F(PreviewTest, CutsSamples) {
  Preview preview(tracer_, small_settings(), ahead_, still_, workers_);
  const auto brightest = [&](float largest) {
    preview.cut_samples(largest);
    preview.restart("od", 1);
    preview.render_frame(Nanoseconds(0), 5000);
    float most = 0.0F;
    for (const Rgb& color : preview.film().resolve().color.pixels) {
      most = std::max(most, max_component(color));
    }
    return most;
  };
  EXPECT_GT(brightest(std::numeric_limits<float>::infinity()), 0.1F);
  EXPECT_LE(brightest(0.1F), 0.1F);
}

TEST_F(PreviewTest, AFrameWithoutSamplesStillPollsAndReports) {
  Preview preview(tracer_, small_settings(), ahead_, still_, workers_);
  preview.restart("fv", 1);
  const FrameReport report = preview.render_frame(preview_frame_time, 0);
  EXPECT_TRUE(report.gaze_valid);
  EXPECT_EQ(report.samples, 0U);
  EXPECT_EQ(report.rays, 0U);
  EXPECT_EQ(preview.film().total_samples(), 0U);
}

TEST_F(PreviewTest, ARestartClearsTheFilmAndCountsAnew) {
  Preview preview(tracer_, small_settings(), ahead_, still_, workers_);
  preview.restart("od", 1);
  preview.render_frame(preview_frame_time, 4096);
  preview.render_frame(preview_frame_time, 4096);
  const FilmImage first = preview.film().resolve();
  preview.restart("fv", 2);
  EXPECT_EQ(preview.film().total_samples(), 0U);
  EXPECT_EQ(preview.render_frame(preview_frame_time, 100).frame, 0U);
  preview.restart("od", 1);
  preview.render_frame(preview_frame_time, 4096);
  preview.render_frame(preview_frame_time, 4096);
  EXPECT_EQ(preview.film().resolve().color.pixels, first.color.pixels);
}

// Two frames of half an image each make one sample in every pixel: the second goes on where the
// first ended.
TEST_F(PreviewTest, FramesContinueOneSequence) {
  Preview preview(tracer_, small_settings(), ahead_, still_, workers_);
  preview.restart("od", 3);
  preview.render_frame(preview_frame_time, 256 * 128 / 2);
  preview.render_frame(preview_frame_time, 256 * 128 / 2);
  EXPECT_THAT(preview.film().resolve().samples, Each(1U));
}

// Without the fixture: its workers would limit the threads of all others.
TEST(PreviewThreads, TheFilmDependsOnTheSeedAndNotOnThreadsOrFrames) {
  const Scene scene = box_room(0.2F);
  FixedEyeTracker eye(Vec3(0.0F, 0.0F, -1.0F));
  ScriptedHeadTracker head({{.time = Nanoseconds(0), .heading = {}}});
  const auto film = [&](int threads, std::uint32_t seed, const std::vector<std::uint64_t>& frames) {
    const Workers workers(threads);
    const PathTracer tracer(scene, workers);
    Preview preview(tracer, small_settings(), eye, head, workers);
    preview.restart("fv", seed);
    for (const std::uint64_t samples : frames) {
      preview.render_frame(preview_frame_time, samples);
    }
    return preview.film().resolve();
  };
  const FilmImage expected = film(1, 7, {30'000});
  for (const int threads : {2, 4}) {
    const FilmImage image = film(threads, 7, {30'000});
    EXPECT_EQ(image.color.pixels, expected.color.pixels) << threads << " threads";
    EXPECT_EQ(image.samples, expected.samples) << threads << " threads";
  }
  EXPECT_EQ(film(2, 7, {1, 4096, 25'903}).color.pixels, expected.color.pixels);
  EXPECT_NE(film(2, 8, {30'000}).color.pixels, expected.color.pixels);
}

TEST_F(PreviewTest, FvSamplesGatherAroundTheGaze) {
  PreviewSettings settings = small_settings();
  settings.render.film_size = {1024, 512};  // so that whole pixels resolve the discs below
  const AzimuthElevation gaze = {.azimuth_rad = radians(60.0), .elevation_rad = radians(-30.0)};
  FixedEyeTracker eye(direction_from(gaze));
  Preview preview(tracer_, settings, eye, still_, workers_);
  preview.restart("fv", 1);
  preview.render_frame(preview_frame_time, 1 << 17);
  const ReddyDistribution distribution(80.0);
  for (const double radius_deg : {5.0, 15.0, 40.0}) {
    const double share = share_of_samples(preview.film(), [&](const Vec3& direction) {
      return turned_deg(direction, direction_from(gaze)) < radius_deg;
    });
    EXPECT_NEAR(share, distribution.cumulative(radius_deg), 0.01) << radius_deg;
  }
}

TEST_F(PreviewTest, VpSamplesStayInTheViewOfTheHead) {
  const AzimuthElevation heading = {.azimuth_rad = radians(170.0), .elevation_rad = radians(20.0)};
  ScriptedHeadTracker head({{.time = Nanoseconds(0), .heading = heading}});
  Preview preview(tracer_, small_settings(), ahead_, head, workers_);
  preview.restart("vp", 1);
  preview.render_frame(preview_frame_time, 50'000);
  const double pixel_rad = 2.0 * std::numbers::pi / 256.0;
  const Viewport wider(head_orientation(heading), radians(100.0) + 4.0 * pixel_rad,
                       radians(100.0) + 4.0 * pixel_rad);
  EXPECT_EQ(share_of_samples(preview.film(),
                             [&](const Vec3& direction) { return wider.project(direction); }),
            1.0);
  EXPECT_LT(turned_deg(preview.viewport().direction(Vec2(0.5F)), direction_from(heading)), 1e-3);
}

// 90 degrees of the head and 20 of the eye make 110 in the world.
TEST_F(PreviewTest, TheGazeTurnsWithTheHead) {
  ScriptedHeadTracker head(
      {{.time = Nanoseconds(0), .heading = {}},
       {.time = preview_frame_time, .heading = {.azimuth_rad = radians(90.0)}}});
  FixedEyeTracker eye(direction_from({.azimuth_rad = radians(20.0)}));
  Preview preview(tracer_, small_settings(), eye, head, workers_);
  preview.restart("fv", 1);
  const FrameReport first = preview.render_frame(Nanoseconds(0), 1);
  EXPECT_LT(turned_deg(first.gaze, direction_from({.azimuth_rad = radians(20.0)})), 1e-3);
  const FrameReport second = preview.render_frame(preview_frame_time, 1);
  EXPECT_LT(turned_deg(second.gaze, direction_from({.azimuth_rad = radians(110.0)})), 1e-3);
  EXPECT_NEAR(second.head.azimuth_rad, radians(90.0), 1e-9);
}

TEST_F(PreviewTest, AHeldGazeStaysWhereItIsInTheWorld) {
  ScriptedHeadTracker head({{.time = preview_frame_time, .heading = {}},
                            {.time = 2 * preview_frame_time, .heading = {.azimuth_rad = 1.0}}});
  Preview preview(tracer_, small_settings(), ahead_, head, workers_);
  preview.restart("fv", 1);
  const FrameReport before = preview.render_frame(preview_frame_time, 100);
  preview.hold_gaze(true);
  const FrameReport held = preview.render_frame(3 * preview_frame_time, 100);
  EXPECT_TRUE(held.gaze_held);
  EXPECT_EQ(held.gaze, before.gaze);
  EXPECT_NEAR(held.head.azimuth_rad, 1.0, 1e-9);
  preview.hold_gaze(false);
  const FrameReport after = preview.render_frame(4 * preview_frame_time, 100);
  EXPECT_FALSE(after.gaze_held);
  EXPECT_NEAR(turned_deg(after.gaze, before.gaze), degrees(1.0), 1e-3);
}

TEST_F(PreviewTest, SamplesGoWhereTheUserPoints) {
  Preview preview(tracer_, small_settings(), ahead_, still_, workers_);
  const Vec3 behind(0.0F, 0.0F, 1.0F);
  const auto share_behind = [&] {
    preview.restart("pointer:radius=5", 1);
    preview.render_frame(preview_frame_time, 5000);
    return share_of_samples(preview.film(),
                            [&](const Vec3& d) { return turned_deg(d, behind) < 30.0; });
  };
  EXPECT_EQ(share_behind(), 0.0);
  preview.point_at(behind);
  EXPECT_EQ(share_behind(), 1.0);
  preview.point_at(std::nullopt);
  EXPECT_EQ(share_behind(), 0.0);
}

// A 256th of the light under 8 stops more looks the same: as much is adaptive.
TEST_F(PreviewTest, WhatIsConvergedDependsOnWhatTheDisplayShows) {
  const auto traced = [&](float light, double exposure_stops) {
    Scene scene = box_room(0.2F);
    for (Material& material : scene.materials) {
      material.emission *= light;
    }
    const PathTracer tracer(scene, workers_);
    PreviewSettings settings = small_settings();
    settings.exposure_stops = exposure_stops;
    settings.render.adaptive = VisibleNoise{.contrast = 0.01, .least_samples = 2};
    Preview preview(tracer, settings, ahead_, still_, workers_);
    preview.restart("fv", 1);
    std::uint64_t samples = 0;
    for (int frame = 0; frame < 6; ++frame) {
      samples += preview.render_frame(frame * preview_frame_time, 4000).samples;
    }
    return samples;
  };
  EXPECT_EQ(traced(0x1p-8F, 8.0), traced(1.0F, 0.0));
  EXPECT_LT(traced(0x1p-8F, 0.0), traced(1.0F, 0.0));
}

TEST_F(PreviewTest, PresentsTheViewOfTheLastFrame) {
  PreviewSettings settings = small_settings();
  settings.exposure_stops = 1.0;
  const AzimuthElevation heading = {.azimuth_rad = 2.0, .elevation_rad = -0.3};
  ScriptedHeadTracker head({{.time = Nanoseconds(0), .heading = heading}});
  Preview preview(tracer_, settings, ahead_, head, workers_);
  preview.restart("fv", 1);
  preview.render_frame(preview_frame_time, 2000);
  const Viewport view(head_orientation(heading), radians(100.0), radians(100.0));
  const RgbImage expected = display_image(
      viewport_image(preview.film(), view, 64, 48, UnsampledPixels::black, workers_), 1.0);
  const RgbImage presented = preview.present();
  EXPECT_EQ(presented.width, 64);
  EXPECT_EQ(presented.height, 48);
  EXPECT_EQ(presented.pixels, expected.pixels);
  EXPECT_NE(presented.pixels, RgbImage(64, 48).pixels);
}

TEST_F(PreviewTest, ReportsSamplesThatAreNotFinite) {
  Scene scene = box_room(0.5F);
  scene.meshes.erase(scene.meshes.begin() + 4);  // the wall ahead
  scene.environment = Environment{.radiance = Rgb(std::numeric_limits<float>::infinity())};
  const PathTracer tracer(scene, workers_);
  Preview preview(tracer, small_settings(), ahead_, still_, workers_);
  preview.restart("od", 1);
  preview.render_frame(preview_frame_time, 10'000);
  EXPECT_EQ(preview.film().total_samples() + preview.dropped().size(), 10'000U);
  EXPECT_GT(preview.dropped().size(), 1000U);  // the missing wall is a sixth of the sphere
  preview.restart("od", 1);
  EXPECT_TRUE(preview.dropped().empty());
}

// A preview that shared paths with the reference of the same seed would look closer to it than it
// is: the noise of both would go together.
TEST_F(PreviewTest, SharesNoNoiseWithTheReferenceOfItsSeed) {
  PreviewSettings settings = small_settings();
  settings.render.film_size = {64, 32};
  Preview preview(tracer_, settings, ahead_, still_, workers_);
  preview.restart("od", 5);
  preview.render_frame(preview_frame_time, 64 * 32);
  const test::TemporaryFolder cache;
  const auto reference = [&](int samples_per_pixel, std::uint32_t seed) {
    const ReferenceSettings same{.width = settings.render.film_size.x,
                                 .height = settings.render.film_size.y,
                                 .max_depth = settings.render.trace.max_depth,
                                 .seed = seed,
                                 .samples_per_pixel = samples_per_pixel};
    return reference_image(tracer_, "room", same, workers_, cache.path(), [](double) {}, {});
  };
  const FilmImage truth = reference(64, 99);
  const FilmImage same_seed = reference(1, 5);
  double covariance = 0.0;
  double variance_preview = 0.0;
  double variance_reference = 0.0;
  for (int y = 0; y < settings.render.film_size.y; ++y) {
    for (int x = 0; x < settings.render.film_size.x; ++x) {
      const double a = preview.film().mean(x, y).g - truth.color.at(x, y).g;
      const double b = same_seed.color.at(x, y).g - truth.color.at(x, y).g;
      covariance += a * b;
      variance_preview += a * a;
      variance_reference += b * b;
    }
  }
  // Of 2048 pixels: five standard errors. The truth's own noise, common to both, is a 64th.
  EXPECT_LT(covariance / std::sqrt(variance_preview * variance_reference),
            1.0 / 64.0 + 5.0 / std::sqrt(2048.0));
}

}  // namespace
}  // namespace foveola
