// The graphics card's picture against the processor's.
#include "renderer/window/drawing/presenter.h"

#include <cmath>

#include <gmock/gmock.h>

#include "renderer/base/error.h"
#include "renderer/base/numbers/random.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/view/equirect.h"
#include "renderer/window/drawing/film_mirror.h"
#include "tests/renderer/window/patterned_film.h"
#include "tests/x_server.h"

namespace foveola {
namespace {

class PresenterTest : public ::testing::Test {
 protected:
  PresenterTest() { test::paint_pattern(film_, workers_); }

  RgbImage picture(const std::vector<ShownView>& views, const ViewLook& look,
                   const ViewOverlays& overlays = {}, const std::vector<TextPanel>& panels = {}) {
    std::vector<Viewport> viewports;
    for (const ShownView& view : views) {
      viewports.push_back(view.viewport);
    }
    ShownFrame frame{.framebuffer = window_.framebuffer_size(),
                     .atlas = &mirror_.atlas(),
                     .update = mirror_.collect(film_, viewports, film_.levels()),
                     .views = views,
                     .look = look,
                     .overlays = overlays,
                     .panels = panels,
                     .picture = std::make_shared<std::promise<RgbImage>>()};
    auto picture = frame.picture->get_future();
    presenter_.draw(std::move(frame));
    return picture.get();
  }

  void expect_like_the_processors(const RgbImage& picture, const ShownView& view,
                                  const ViewLook& look) {
    test::expect_like_the_processors(picture, view, look, film_, workers_);
  }

  ShownView whole_window(const AzimuthElevation& heading, double fov_deg = 90.0) {
    return {
        .viewport = Viewport(head_orientation(heading), radians(fov_deg), radians(0.8 * fov_deg)),
        .part = {.origin = IVec2(0), .size = window_.framebuffer_size()}};
  }

  test::XServer server_;
  SteadyClock clock_;
  WindowEvents events_;
  Window window_{{.size = {320, 256}}, events_, clock_};
  Workers workers_{2};
  EquirectFilm film_{600, 300};
  FilmMirror mirror_{film_};
  WindowPresenter presenter_{window_, window_.framebuffer_size(), clock_};
};

TEST_F(PresenterTest, DrawsWhatTheProcessorDraws) {
  for (const auto& [azimuth_deg, elevation_deg] :
       {std::pair(0.0, 0.0), std::pair(180.0, 10.0), std::pair(40.0, 85.0),
        std::pair(-100.0, -70.0)}) {
    const ShownView view = whole_window({radians(azimuth_deg), radians(elevation_deg)});
    SCOPED_TRACE(azimuth_deg);
    expect_like_the_processors(picture({view}, {}), view, {});
  }
}

TEST_F(PresenterTest, ReadsCoarserLevelsOfTheFilm) {
  const ShownView view = whole_window({}, 170.0);
  expect_like_the_processors(picture({view}, {}), view, {});
}

TEST_F(PresenterTest, FillsUnsampledPixelsLikeTheProcessor) {
  const ViewLook look{.exposure_stops = -1.0, .fill_unsampled = true};
  const ShownView view = whole_window({radians(20.0), 0.0}, 40.0);
  expect_like_the_processors(picture({view}, look), view, look);
}

TEST_F(PresenterTest, DrawsForTwoEyesThroughTheirLenses) {
  const RadialLens lens{.axis = {0.55F, 0.5F}, .k1 = 0.2F, .k2 = 0.05F};
  const Quat head = head_orientation({radians(-30.0), radians(5.0)});
  const ShownView left{.viewport = Viewport(head, radians(90.0), radians(90.0), lens),
                       .part = {.origin = {0, 0}, .size = {160, 256}}};
  const ShownView right{.viewport = Viewport(head, radians(90.0), radians(90.0), mirrored(lens)),
                        .part = {.origin = {160, 0}, .size = {160, 256}}};
  const RgbImage shown = picture({left, right}, {});
  expect_like_the_processors(shown, left, {});
  expect_like_the_processors(shown, right, {});
}

TEST_F(PresenterTest, DrawsDensities) {
  const ShownView view = whole_window({});
  const DensityMap map{.width = 2, .height = 1, .values = {0.0F, 1.0F}};
  const RgbImage shown = picture({view}, {}, {.density = map});
  const RgbImage plain = picture({view}, {});
  const Rgb left = shown.at(20, 128) - plain.at(20, 128);
  const Rgb right = shown.at(300, 128) - plain.at(300, 128);
  EXPECT_GT(left.b - left.r, 0.1F);    // few: blue
  EXPECT_GT(right.r - right.b, 0.1F);  // many: red
}

TEST_F(PresenterTest, ShowsATargetAlone) {
  const ShownView view = whole_window({}, 20.0);
  const RgbImage shown = picture(
      {view}, {}, {.target = view.viewport.direction(Vec2(160.5F, 128.5F) / Vec2(320, 256))});
  EXPECT_EQ(shown.at(160, 128), Rgb(1.0F));
  // Black from 0.1 to 0.3 degrees: 0.063 degrees a pixel.
  EXPECT_EQ(shown.at(163, 128), Rgb(0.0F));
  EXPECT_NEAR(shown.at(170, 128).g, 0.5, 0.01);
}

TEST_F(PresenterTest, WritesText) {
  const ShownView view = whole_window({});
  const RgbImage plain = picture({view}, {});
  const std::vector<TextPanel> panels = {{.lines = {"How it goes"}}};
  const RgbImage shown = picture({view}, {}, {}, panels);
  int changed = 0;
  int white = 0;
  for (int y = 8; y < 30; ++y) {
    for (int x = 8; x < 90; ++x) {
      changed += shown.at(x, y) != plain.at(x, y) ? 1 : 0;
      white += glm::all(glm::greaterThan(shown.at(x, y), Rgb(0.9F))) ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 1000);
  EXPECT_GT(white, 30);
  EXPECT_EQ(shown.at(250, 200), plain.at(250, 200));
}

TEST_F(PresenterTest, PicturesOfTheFilmAreBare) {
  const ShownView view = whole_window({});
  ShownFrame frame{.framebuffer = window_.framebuffer_size(),
                   .update = mirror_.collect(film_, std::vector{view.viewport}, film_.levels()),
                   .views = {view},
                   .overlays = {.shows_gaze = true, .rings_rad = {0.3F}},
                   .panels = {{.lines = {"How it goes"}}},
                   .picture_is_bare = true};
  std::future<RgbImage> bare = picture_of(frame);
  presenter_.draw(std::move(frame));
  EXPECT_EQ(bare.get().pixels, picture({view}, {}).pixels);
}

TEST_F(PresenterTest, ReportsWhenFramesWereShown) {
  const Nanoseconds before = clock_.now();
  const ShownView view = whole_window({});
  picture({view}, {});
  const Nanoseconds shown = presenter_.wait_until_shown();
  EXPECT_GE(shown, before);
  EXPECT_GE(clock_.now(), shown);
  picture({view}, {});
  EXPECT_GT(presenter_.wait_until_shown(), shown);
  EXPECT_FALSE(presenter_.graphics().empty());
}

TEST_F(PresenterTest, AHiddenWindowIsNotDrawn) {
  ShownFrame frame{.picture = std::make_shared<std::promise<RgbImage>>()};
  auto picture = frame.picture->get_future();
  presenter_.draw(std::move(frame));
  presenter_.draw({});  // by now the first one is forgotten
  EXPECT_THROW(picture.get(), std::future_error);
}

TEST(PresenterErrors, AFilmBeyondTheCardsTexturesIsRefused) {
  const test::XServer server;
  const SteadyClock clock;
  WindowEvents events;
  Window window({.size = {64, 64}}, events, clock);
  WindowPresenter presenter(window, window.framebuffer_size(), clock);
  const PyramidAtlas atlas(65536, 16);
  EXPECT_THROW(presenter.draw({.framebuffer = {64, 64}, .atlas = &atlas}), Error);
}

}  // namespace
}  // namespace foveola
