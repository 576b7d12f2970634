#include <gtest/gtest.h>

#include "renderer/base/work/parallel.h"
#include "renderer/window/drawing/film_drawing.h"
#include "tests/renderer/window/patterned_film.h"

namespace foveola {
namespace {

/// For each eye, 10 degrees wide: it shows a small part of the film.
ViewGeometry two_eyes() {
  return {
      .horizontal_fov_deg = 10.0,
      .vertical_fov_deg = 10.0,
      .lens = {.axis = {0.6F, 0.5F}},
      .parts = {{.origin = {0, 0}, .size = {100, 80}}, {.origin = {100, 0}, .size = {100, 80}}}};
}

const WindowArea open_area{.framebuffer = {200, 80}};

/// A sample in the middle of the image, straight ahead, and one at its left edge, behind.
void sample_ahead_and_behind(EquirectFilm& film) {
  test::add_samples(film, {Vec2(0.501F, 0.501F), Vec2(0.001F, 0.501F)}, {Rgb(1.0F), Rgb(1.0F)},
                    Workers(1));
}

/// Whether the update has full-resolution cells of the film at this column.
bool tells_of_column(const FilmUpdate& update, int column) {
  return std::any_of(update.begin(), update.end(), [&](const AtlasRectangle& part) {
    return part.y < 256 && part.x <= column && column < part.x + part.width;
  });
}

TEST(HeadFrameTest, GivesEachEyeItsViewAndItsPartOfTheWindow) {
  const Quat head = head_orientation({.azimuth_rad = 1.0});
  const ShownFrame frame = head_frame(open_area, two_eyes(), head, {.exposure_stops = 2.0F});
  EXPECT_EQ(frame.framebuffer, IVec2(200, 80));
  EXPECT_EQ(frame.look.exposure_stops, 2.0F);
  ASSERT_EQ(frame.views.size(), 2U);
  EXPECT_EQ(frame.views[0].part.origin, IVec2(0, 0));
  EXPECT_EQ(frame.views[1].part.origin, IVec2(100, 0));
  EXPECT_FLOAT_EQ(frame.views[0].viewport.lens().axis.x, 0.6F);
  EXPECT_FLOAT_EQ(frame.views[1].viewport.lens().axis.x, 0.4F);
  EXPECT_EQ(frame.views[1].viewport.head(), head);
}

TEST(HeadFrameTest, NothingIsDrawnOfAWindowThatIsNotSeen) {
  const auto drawn = [](const WindowArea& area) {
    return head_frame(area, two_eyes(), head_orientation({}), {}).framebuffer;
  };
  EXPECT_EQ(drawn({.framebuffer = {200, 80}, .is_hidden = true}), IVec2(0));
  EXPECT_EQ(drawn({.framebuffer = {1, 80}}), IVec2(0));
  EXPECT_EQ(drawn({.framebuffer = {200, 0}}), IVec2(0));
  EXPECT_EQ(drawn({.framebuffer = {2, 1}}), IVec2(2, 1));
}

TEST(HeadFrameTest, OnlyWhatIsSeenOfTheFilmIsSentAndOnlyOnce) {
  EquirectFilm film(512, 256);
  FilmMirror mirror(film);
  sample_ahead_and_behind(film);
  const ShownFrame frame = head_frame(open_area, two_eyes(), head_orientation({}), {});
  const FilmUpdate first = update_for(frame, film, mirror);
  EXPECT_TRUE(tells_of_column(first, 256));
  EXPECT_FALSE(tells_of_column(first, 0));
  EXPECT_TRUE(update_for(frame, film, mirror).empty());
}

TEST(HeadFrameTest, UnsampledPixelsAreFilledFromCoarserLevelsThanTheViewShows) {
  EquirectFilm film(512, 256);
  sample_ahead_and_behind(film);
  const auto texels = [&](const ViewLook& look) {
    FilmMirror mirror(film);
    const ShownFrame frame = head_frame(open_area, two_eyes(), head_orientation({}), look);
    return update_for(frame, film, mirror).size();
  };
  EXPECT_GT(texels({.fill_unsampled = true}), texels({.fill_unsampled = false}));
}

}  // namespace
}  // namespace foveola
