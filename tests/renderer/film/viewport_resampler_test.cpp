// Frame after frame, a resampler must show what one that knows nothing of earlier frames shows.
#include "renderer/film/viewport_resampler.h"

#include <array>
#include <ostream>

#include <gtest/gtest.h>

#include "renderer/image/tone_mapping.h"
#include "tests/renderer/film/film_samples.h"

namespace foveola {
namespace {

constexpr int shown_width = 91;  // rows are not made of whole eights
constexpr int shown_height = 67;

Viewport view_towards(double azimuth_deg, double elevation_deg, double fov_deg = 90.0,
                      const RadialLens& lens = {}) {
  return {head_orientation(
              {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)}),
          radians(fov_deg), radians(fov_deg), lens};
}

struct Case {
  const char* name;
  IVec2 film_size;
  Viewport viewport;
  UnsampledPixels unsampled = UnsampledPixels::black;
};

std::ostream& operator<<(std::ostream& out, const Case& shown) { return out << shown.name; }

class Resampler : public testing::TestWithParam<Case> {
 protected:
  /// Every frame has samples of its own: many, few, or none.
  void add_frame() {
    constexpr std::array<std::uint64_t, 4> counts = {400, 3, 60, 0};
    const std::uint64_t count = counts[frame_++ % counts.size()];
    add_samples(sobol_samples(first_, count), film_, workers_);
    first_ += count;
  }

  void expect_shown(const Viewport& viewport) {
    const RgbImage anew =
        viewport_image(film_, viewport, shown_width, shown_height, GetParam().unsampled, workers_);
    EXPECT_EQ(resampler_.show(viewport, workers_).pixels, anew.pixels) << "frame " << frame_;
  }

  const Workers workers_{2};
  EquirectFilm film_{GetParam().film_size.x, GetParam().film_size.y};
  ViewportResampler resampler_{
      film_, {.width = shown_width, .height = shown_height, .unsampled = GetParam().unsampled}};
  std::uint64_t first_ = 0;
  std::size_t frame_ = 0;
};

TEST_P(Resampler, ShowsWhatIsNew) {
  expect_shown(GetParam().viewport);
  for (int frame = 0; frame < 40; ++frame) {
    add_frame();
    expect_shown(GetParam().viewport);
  }
  EXPECT_NE(resampler_.show(GetParam().viewport, workers_).pixels,
            RgbImage(shown_width, shown_height).pixels);
}

TEST_P(Resampler, ShowsWhatChangedSeveralTimesBetweenFrames) {
  for (int frame = 0; frame < 12; ++frame) {
    add_frame();
    add_frame();
    add_frame();
    expect_shown(GetParam().viewport);
  }
}

TEST_P(Resampler, ForgetsWithTheFilm) {
  for (int frame = 0; frame < 20; ++frame) {
    if (frame % 6 == 5) {
      film_.clear();
    }
    if (frame % 12 != 5) {
      add_frame();
    }
    expect_shown(GetParam().viewport);
  }
}

// What was out of sight meanwhile has changed, or was cleared.
TEST_P(Resampler, FollowsTheHead) {
  for (int frame = 0; frame < 48; ++frame) {
    if (frame == 31) {
      film_.clear();
    }
    add_frame();
    if (frame % 3 == 0) {
      expect_shown(GetParam().viewport);
    } else if (frame % 8 < 4) {
      expect_shown(view_towards(37.0 * frame, 80.0 - 10.0 * (frame % 17)));
    }
  }
}

TEST_P(Resampler, FollowsTheFieldOfView) {
  for (const double fov_deg : {90.0, 40.0, 150.0, 90.0}) {
    add_frame();
    expect_shown(view_towards(10.0, 20.0, fov_deg));
    add_frame();
    expect_shown(view_towards(10.0, 20.0, fov_deg));
  }
}

TEST_P(Resampler, FollowsTheLook) {
  const Viewport& viewport = GetParam().viewport;
  ViewImage look{.width = shown_width, .height = shown_height};
  for (int frame = 0; frame < 18; ++frame) {
    add_frame();
    if (frame % 3 == 0) {
      look.unsampled = frame % 2 == 0 ? UnsampledPixels::filled : UnsampledPixels::black;
      look.exposure_stops = 0.2 * frame;
      look.curve = frame % 4 < 2 ? ToneCurve::plain : ToneCurve::filmic;
      resampler_.change_look(look);
    }
    const RgbImage anew =
        viewport_image(film_, viewport, shown_width, shown_height, look.unsampled, workers_);
    EXPECT_EQ(resampler_.show(viewport, workers_).pixels,
              display_image(anew, *look.exposure_stops, look.curve).pixels)
        << "frame " << frame;
  }
}

TEST_P(Resampler, ShowsANewLookOfAnOldFilm) {
  add_frame();
  resampler_.change_look({.width = shown_width, .height = shown_height, .exposure_stops = 0.0});
  const RgbImage before = resampler_.show(GetParam().viewport, workers_);
  resampler_.change_look({.width = shown_width, .height = shown_height, .exposure_stops = -3.0});
  EXPECT_NE(resampler_.show(GetParam().viewport, workers_).pixels, before.pixels);
}

constexpr RadialLens resampled_lens{.axis = {0.44F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F};

INSTANTIATE_TEST_SUITE_P(
    Everywhere, Resampler,
    testing::Values(Case{"Ahead", {512, 256}, view_towards(0.0, 0.0)},
                    Case{"Seam", {512, 256}, view_towards(180.0, 10.0)},
                    Case{"Zenith", {512, 256}, view_towards(50.0, 88.0)},
                    Case{"Nadir", {512, 256}, view_towards(-50.0, -70.0)},
                    Case{"Narrow", {512, 256}, view_towards(-100.0, 5.0, 15.0)},
                    Case{"Lens", {512, 256}, view_towards(170.0, -30.0, 80.0, resampled_lens)},
                    Case{"LargeFilm", {4096, 2048}, view_towards(20.0, 0.0)},
                    Case{"HugeFilm", {16384, 8192}, view_towards(20.0, 0.0)},
                    Case{"TilesThatReachBeyond", {301, 141}, view_towards(180.0, -60.0)},
                    Case{"OddFilm", {27, 13}, view_towards(180.0, 0.0)},
                    Case{"OddQuads", {54, 26}, view_towards(180.0, -60.0)},
                    Case{"TinyFilm", {8, 4}, view_towards(0.0, 0.0)},
                    Case{"Filled", {512, 256}, view_towards(180.0, 40.0), UnsampledPixels::filled}),
    [](const testing::TestParamInfo<Case>& tested) { return tested.param.name; });

TEST(ViewportResampler, EncodesForADisplay) {
  const Workers workers(2);
  EquirectFilm film(256, 128);
  ViewportResampler resampler(
      film, {.width = shown_width, .height = shown_height, .exposure_stops = 1.5});
  const Viewport ahead = view_towards(0.0, 0.0);
  for (std::uint64_t frame = 0; frame < 3; ++frame) {
    add_samples(sobol_samples(1000 * frame, 1000), film, workers);
    const RgbImage linear =
        viewport_image(film, ahead, shown_width, shown_height, UnsampledPixels::black, workers);
    EXPECT_EQ(resampler.show(ahead, workers).pixels, display_image(linear, 1.5).pixels);
  }
}

TEST(ViewportResampler, ShowsTheSameOnAnyNumberOfThreads) {
  const Workers one(1);
  const Workers four(4);
  EquirectFilm film(512, 256);
  ViewportResampler of_one(film, {.width = shown_width, .height = shown_height});
  ViewportResampler of_four(film, {.width = shown_width, .height = shown_height});
  for (std::uint64_t frame = 0; frame < 6; ++frame) {
    add_samples(sobol_samples(500 * frame, 500), film, one);
    const Viewport viewport = view_towards(frame < 3 ? 0.0 : 60.0, 0.0);
    EXPECT_EQ(of_one.show(viewport, one).pixels, of_four.show(viewport, four).pixels);
  }
}

}  // namespace
}  // namespace foveola
