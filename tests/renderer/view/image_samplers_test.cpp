#include "renderer/view/image_samplers.h"

#include <cmath>

#include <gtest/gtest.h>

#include "renderer/view/equirect.h"

namespace foveola {
namespace {

Viewport looking(double azimuth_deg, double elevation_deg, double width_deg, double height_deg) {
  return {head_orientation(
              {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)}),
          radians(width_deg), radians(height_deg)};
}

/// Holds every point of the view, and its sides touch some: found by walking over a fine grid.
void expect_bounds(const Viewport& viewport) {
  const ImageRectangle rectangle = bounding_rectangle(viewport);
  constexpr int steps = 400;
  double left = 1.0;
  double right = 0.0;
  double top = 1.0;
  double bottom = 0.0;
  ImageRectangle wider = rectangle;
  wider.u_begin -= 1e-6;
  wider.width += 2e-6;
  wider.v_begin -= 1e-6;
  wider.v_end += 1e-6;
  for (int y = 0; y <= steps; ++y) {
    for (int x = 0; x <= steps; ++x) {
      const Vec2 plane(static_cast<float>(x) / steps, static_cast<float>(y) / steps);
      const Vec2 image = equirect_from_direction(viewport.direction(plane));
      ASSERT_TRUE(wider.contains(image)) << image.x << ", " << image.y;
      const double along = image.x - rectangle.u_begin + 1e-6;
      left = std::min(left, along - std::floor(along));
      right = std::max(right, along - std::floor(along));
      top = std::min<double>(top, image.y);
      bottom = std::max<double>(bottom, image.y);
    }
  }
  EXPECT_NEAR(top, rectangle.v_begin, 1e-3);
  EXPECT_NEAR(bottom, rectangle.v_end, 1e-3);
  EXPECT_NEAR(left, 0.0, 2e-3);
  EXPECT_NEAR(right, rectangle.width, 2e-3);
}

TEST(BoundingRectangle, HoldsTheViewAndNoMore) {
  expect_bounds(looking(0, 0, 100, 80));
  expect_bounds(looking(40, 0, 30, 20));
  expect_bounds(looking(-30, 30, 60, 60));
  expect_bounds(looking(100, -45, 60, 40));
}

TEST(BoundingRectangle, GoesOnAcrossTheSeam) {
  expect_bounds(looking(180, 0, 100, 80));
  expect_bounds(looking(-170, 20, 60, 60));
}

TEST(BoundingRectangle, IsAllAroundWhereTheViewHoldsAPole) {
  for (const double sign : {1.0, -1.0}) {
    const ImageRectangle rectangle = bounding_rectangle(looking(70, sign * 60, 90, 90));
    EXPECT_EQ(rectangle.width, 1.0);
    EXPECT_EQ(sign > 0 ? rectangle.v_begin : 1.0 - rectangle.v_end, 0.0);
    expect_bounds(looking(70, sign * 60, 90, 90));
    expect_bounds(looking(70, sign * 89.5, 90, 70));
  }
}

// A lens bows the edges of the view outwards or inwards.
TEST(BoundingRectangle, HoldsTheViewThroughALens) {
  for (const RadialLens& lens :
       {RadialLens{.axis = {0.56F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F}, RadialLens{.k1 = -0.1F}}) {
    for (const double elevation_deg : {0.0, 30.0, 85.0}) {
      const Viewport straight = looking(170.0, elevation_deg, 90.0, 80.0);
      expect_bounds(Viewport(straight.head(), radians(90.0), radians(80.0), lens));
    }
  }
}

TEST(BoundingRectangle, IsNarrowJustBelowAPole) { expect_bounds(looking(20, 50, 60, 70)); }

TEST(ImageRectangle, PlacesStayInTheImage) {
  const ImageRectangle rectangle{.u_begin = 0.9, .width = 0.2, .v_begin = 0.25, .v_end = 0.5};
  EXPECT_NEAR(rectangle.area(), 0.05, 1e-12);
  for (const float x : {0.0F, 0.25F, 0.5F, 0.75F, 0x1.fffffep-1F}) {
    const Vec2 place = rectangle.place({x, 0.5F});
    EXPECT_GE(place.x, 0.0F);
    EXPECT_LT(place.x, 1.0F);
    EXPECT_FLOAT_EQ(place.y, 0.375F);
  }
  EXPECT_TRUE(rectangle.contains(rectangle.place({0.25F, 0.5F})));
  EXPECT_TRUE(rectangle.contains(rectangle.place({0.75F, 0.5F})));
  EXPECT_FALSE(rectangle.contains({0.5F, 0.3F}));
  EXPECT_FALSE(rectangle.contains({0.95F, 0.6F}));
}

}  // namespace
}  // namespace foveola
