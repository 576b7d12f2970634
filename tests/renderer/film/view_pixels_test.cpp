#include "renderer/film/view_pixels.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace foveola {
namespace {

void expect_levels(double fov_deg, const RadialLens& lens) {
  constexpr int width = 203;  // no whole eights
  constexpr int height = 101;
  constexpr int film_height = 2048;
  constexpr int last_level = 4;
  const Viewport view(head_orientation({}), radians(fov_deg), radians(0.6 * fov_deg), lens);
  ViewPixels pixels(width, height);
  pixels.choose_levels(view, film_height, last_level, 0, 40);
  pixels.choose_levels(view, film_height, last_level, 40, height);
  float highest = 0.0F;
  for (std::uint32_t pixel = 0; pixel < pixels.count(); ++pixel) {
    const Vec2 plane((static_cast<float>(pixel % width) + 0.5F) / width,
                     (static_cast<float>(pixel / width) + 0.5F) / height);
    const float level =
        std::min(level_for(view.sr_per_area(plane) / pixels.count(), film_height), 4.0F);
    EightPixels eight;
    eight.fill(pixel);
    ASSERT_EQ(pixels.points(eight).level[0], level) << fov_deg << " degrees, pixel " << pixel;
    highest = std::max(highest, level);
  }
  EXPECT_EQ(pixels.highest_level(), highest);
}

TEST(ViewPixels, LevelsAreThoseOfTheirSteradians) {
  for (const double fov_deg : {2.0, 15.0, 60.0, 100.0, 150.0, 179.9}) {
    expect_levels(fov_deg, {});
  }
  expect_levels(90.0, {.axis = {0.44F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F});
}

}  // namespace
}  // namespace foveola
