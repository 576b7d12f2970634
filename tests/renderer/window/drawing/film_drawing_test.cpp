#include "renderer/window/drawing/film_drawing.h"

#include <future>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/window/drawing/presenter.h"
#include "tests/renderer/window/patterned_film.h"
#include "tests/x_server.h"

namespace foveola {
namespace {

TEST(UsualDrawer, IsTheProcessorWhereOpenGlIsSoftware) {
  EXPECT_EQ(default_drawer("llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 Mesa 22.3.6"),
            FilmDrawer::processor);
  EXPECT_EQ(default_drawer("softpipe, OpenGL 3.3"), FilmDrawer::processor);
  EXPECT_EQ(default_drawer("Mesa Intel(R) UHD Graphics 620 (KBL GT2), OpenGL 4.6"),
            FilmDrawer::graphics_card);
  EXPECT_EQ(default_drawer("NVIDIA GeForce RTX 3060/PCIe/SSE2, OpenGL 3.3.0"),
            FilmDrawer::graphics_card);
}

TEST(FrameBudgetFor, WantsMoreForTracingWhereBothAreTheProcessorsWork) {
  const Nanoseconds interval = std::chrono::milliseconds(16);
  const auto tracing_of_first_frame = [&](FilmDrawer drawer) {
    FrameBudget budget = frame_budget_for(drawer);
    for (int frame = 0; frame < 100; ++frame) {
      budget.begin_frame(interval, interval);
      budget.rest_took(interval / 2);
      budget.frame_ended(false);
    }
    return budget.begin_frame(interval, interval);
  };
  EXPECT_EQ(tracing_of_first_frame(FilmDrawer::graphics_card), interval);
  EXPECT_GT(tracing_of_first_frame(FilmDrawer::processor), interval);
}

class FilmDrawingTest : public ::testing::TestWithParam<FilmDrawer> {
 protected:
  void add_samples(EquirectFilm& film, const Rgb& color) {
    std::vector<Vec2> images(20'000);
    for (Vec2& image : images) {
      const double u = random_.uniform();
      image = Vec2(u, random_.uniform());
    }
    test::add_samples(film, images, std::vector<Rgb>(images.size(), color), workers_);
  }

  /// Two views side by side, the second through a lens.
  ShownFrame frame(const AzimuthElevation& heading) const {
    const Quat head = head_orientation(heading);
    const RadialLens lens{.axis = {0.45F, 0.5F}, .k1 = 0.2F};
    return {.framebuffer = size_,
            .views = {{.viewport = Viewport(head, radians(60.0), radians(50.0)),
                       .part = {.origin = {0, 0}, .size = {70, 80}}},
                      {.viewport = Viewport(head, radians(70.0), radians(80.0), lens),
                       .part = {.origin = {70, 0}, .size = {90, 80}}}}};
  }

  /// Draws the frame, and holds it against what viewport_image says of the film.
  void expect_shown(FilmDrawing& drawing, const EquirectFilm& film, ShownFrame frame) {
    drawing.bring_up_to_date(frame);
    const std::vector<ShownView> views = frame.views;
    const ViewLook look = frame.look;
    std::future<RgbImage> picture = picture_of(frame);
    presenter_.draw(std::move(frame));
    const RgbImage shown = picture.get();
    for (const ShownView& view : views) {
      // Positions on the card are off by a thousandth of a pixel: 20 pixels of the smaller view.
      const double differing_share = GetParam() == FilmDrawer::processor ? 0.0 : 20.0 / 5600.0;
      test::expect_like_the_processors(shown, view, look, film, workers_, differing_share);
    }
  }

  IVec2 size_{160, 80};
  test::XServer server_;
  SteadyClock clock_;
  WindowEvents events_;
  Window window_{{.size = size_}, events_, clock_};
  Workers workers_{2};
  WindowPresenter presenter_{window_, window_.framebuffer_size(), clock_};
  Pcg32 random_{7, 9};
};

TEST_P(FilmDrawingTest, ShowsTheFilmAsItIsFrameAfterFrame) {
  EquirectFilm film(256, 128);
  FilmDrawing drawing(film, GetParam(), workers_);
  expect_shown(drawing, film, frame({}));
  add_samples(film, {0.1F, 0.4F, 0.7F});
  expect_shown(drawing, film, frame({}));
  add_samples(film, {0.9F, 0.2F, 0.1F});
  expect_shown(drawing, film, frame({radians(100.0), radians(50.0)}));
  film.clear();
  expect_shown(drawing, film, frame({radians(100.0), radians(50.0)}));
}

TEST_P(FilmDrawingTest, FollowsTheLookAndTheSizeOfTheViews) {
  EquirectFilm film(256, 128);
  add_samples(film, {0.1F, 0.4F, 0.7F});
  FilmDrawing drawing(film, GetParam(), workers_);
  ShownFrame brighter = frame({});
  brighter.look.exposure_stops = 1.0;
  expect_shown(drawing, film, std::move(brighter));
  ShownFrame filmic = frame({});
  filmic.look.exposure_stops = 2.0;
  filmic.look.curve = ToneCurve::filmic;
  expect_shown(drawing, film, std::move(filmic));
  ShownFrame filled = frame({});
  filled.look.fill_unsampled = true;
  expect_shown(drawing, film, std::move(filled));
  ShownFrame smaller = frame({});
  smaller.views[0].part.size = {40, 50};
  smaller.views[0].part.origin.y = 30;
  expect_shown(drawing, film, std::move(smaller));
}

TEST_P(FilmDrawingTest, ShowsNothingOfTheFilmBefore) {
  EquirectFilm white(256, 128);
  add_samples(white, Rgb(1.0F));
  FilmDrawing first(white, GetParam(), workers_);
  expect_shown(first, white, frame({}));
  const EquirectFilm empty(256, 128);
  FilmDrawing second(empty, GetParam(), workers_);
  expect_shown(second, empty, frame({}));
}

INSTANTIATE_TEST_SUITE_P(Drawers, FilmDrawingTest,
                         ::testing::Values(FilmDrawer::graphics_card, FilmDrawer::processor),
                         [](const auto& info) {
                           return info.param == FilmDrawer::processor ? "Processor"
                                                                      : "GraphicsCard";
                         });

}  // namespace
}  // namespace foveola
