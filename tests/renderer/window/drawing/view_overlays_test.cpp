// What is drawn over the film, as it is seen: in views 100 degrees wide and high, over white.
#include "renderer/window/drawing/view_overlays.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/renderer/window/screen_capture.h"

namespace foveola {
namespace {

constexpr test::WindowCase one_view{"800x450", {800, 450}, false};
constexpr test::WindowCase two_views{"headset", {800, 450}, true};

Vec3 towards(double azimuth_deg, double elevation_deg) {
  return direction_from(
      {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)});
}

OfferRing offer(double azimuth_deg, double elevation_deg, double radius_deg, bool is_highlighted) {
  return {.direction = towards(azimuth_deg, elevation_deg),
          .radius_rad = static_cast<float>(radians(radius_deg)),
          .is_highlighted = is_highlighted};
}

bool is_white(const Rgb& color) { return glm::all(glm::greaterThan(color, Rgb(0.99F))); }
bool is_dark(const Rgb& color) { return max_component(color) < 0.5F; }

/// How many pixels are not white between two corners.
int marked(const RgbImage& picture, const IVec2& low, const IVec2& high) {
  int count = 0;
  for (int y = low.y; y < high.y; ++y) {
    for (int x = low.x; x < high.x; ++x) {
      count += is_white(picture.at(x, y)) ? 0 : 1;
    }
  }
  return count;
}

/// Where a view of so many pixels shows a direction.
IVec2 place_of(const Vec3& direction, const IVec2& size) {
  const Viewport view(head_orientation({}), radians(100.0), radians(100.0));
  return IVec2(*view.project(direction) * Vec2(size));
}

TEST(ViewOverlaysTest, OffersAreRingsAroundWhatIsOffered) {
  test::ScreenCapture capture(one_view);
  const RgbImage picture =
      capture.capture({.offers = {offer(0.0, 0.0, 8.0, false), offer(30.0, -20.0, 6.0, true)}});
  test::keep_for_people("overlays-offers", picture);
  const auto color = [&](double azimuth_deg, double elevation_deg) {
    const IVec2 at = place_of(towards(azimuth_deg, elevation_deg), one_view.size);
    return picture.at(at.x, at.y);
  };
  for (const double side : {-8.0, 8.0}) {
    EXPECT_TRUE(is_white(color(side, 0.0)) && is_white(color(0.5 * side, 0.0)));
    EXPECT_TRUE(is_dark(color(side + 0.45, 0.0)) && is_dark(color(side - 0.45, 0.0))) << side;
  }
  EXPECT_GT(color(30.0, -14.0).r, 0.9F);
  EXPECT_LT(color(30.0, -14.0).b, 0.2F);
  EXPECT_TRUE(is_white(color(30.0, -20.0)));
}

TEST(ViewOverlaysTest, ARingReachesTheEdgesThatCutIt) {
  test::ScreenCapture capture(one_view);
  const RgbImage picture = capture.capture({.offers = {offer(45.0, 45.0, 20.0, false)}});
  test::keep_for_people("overlays-cut-ring", picture);
  EXPECT_GT(marked(picture, {0, 0}, {800, 1}), 0);
  EXPECT_GT(marked(picture, {799, 0}, {800, 450}), 0);
  EXPECT_EQ(marked(picture, {0, 225}, {400, 450}), 0);
}

TEST(ViewOverlaysTest, RingsSayHowManyDegreesTheyAre) {
  test::ScreenCapture capture(one_view);
  const auto ring_rad = static_cast<float>(radians(20.0));
  const RgbImage picture = capture.capture({.shows_gaze = true, .rings_rad = {ring_rad}});
  test::keep_for_people("overlays-rings", picture);
  const IVec2 top = place_of(towards(0.0, 20.0), one_view.size);
  EXPECT_TRUE(is_dark(picture.at(top.x - 11, top.y - 4))) << "the label's ground, above the ring";
  EXPECT_EQ(marked(picture, {0, 0}, {800, top.y - 24}), 0);
  const Rgb gaze = picture.at(400, 225);
  EXPECT_GT(gaze.r, 0.9F);
  EXPECT_LT(gaze.g, 0.3F);
}

TEST(ViewOverlaysTest, EachEyeSeesTheSame) {
  test::ScreenCapture capture(two_views);
  const RgbImage picture = capture.capture({.gaze = towards(-20.0, 10.0), .shows_gaze = true});
  test::keep_for_people("overlays-headset", picture);
  const IVec2 at = place_of(towards(-20.0, 10.0), {400, 450});
  EXPECT_LT(picture.at(at.x, at.y).g, 0.3F);
  EXPECT_LT(picture.at(400 + at.x, at.y).g, 0.3F);
  EXPECT_EQ(marked(picture, {0, 0}, {400, 450}), marked(picture, {400, 0}, {800, 450}));
}

TEST(ViewOverlaysTest, ATargetIsAsLargeAsAsked) {
  test::ScreenCapture capture(one_view);
  const auto black = [&](float least_px) {
    const RgbImage picture =
        capture.capture({.target = Vec3(0.0F, 0.0F, -1.0F), .min_target_px = least_px});
    return std::count_if(picture.pixels.begin(), picture.pixels.end(),
                         [](const Rgb& color) { return max_component(color) < 0.1F; });
  };
  EXPECT_LT(black(0.0F), 20) << "0.6 degrees";
  EXPECT_GT(black(10.0F), 100) << "20 pixels across";
}

TEST(ViewOverlaysTest, WhatLiesBehindIsNotDrawn) {
  test::ScreenCapture capture(one_view);
  const RgbImage picture = capture.capture({.gaze = towards(180.0, 0.0),
                                            .shows_gaze = true,
                                            .rings_rad = {static_cast<float>(radians(40.0))},
                                            .offers = {offer(150.0, 0.0, 10.0, false)}});
  EXPECT_EQ(marked(picture, {0, 0}, {800, 450}), 0);
}

TEST(ViewOverlaysTest, AnArrowPointsToTheHighlightedOneThatIsNotSeen) {
  test::ScreenCapture capture(one_view);
  const auto picture_towards = [&](double azimuth_deg, double elevation_deg) {
    return capture.capture({.offers = {offer(azimuth_deg, elevation_deg, 8.0, true)}});
  };
  const RgbImage right = picture_towards(150.0, 0.0);
  test::keep_for_people("overlays-arrow", right);
  EXPECT_GT(marked(right, {400, 0}, {800, 450}), 1000);
  EXPECT_EQ(marked(right, {0, 0}, {400, 450}), 0);
  EXPECT_EQ(marked(picture_towards(-80.0, 0.0), {400, 0}, {800, 450}), 0);
  EXPECT_EQ(marked(picture_towards(0.0, 80.0), {0, 225}, {800, 450}), 0);
  EXPECT_EQ(marked(picture_towards(0.0, -80.0), {0, 0}, {800, 225}), 0);
  EXPECT_GT(marked(picture_towards(180.0, 0.0), {400, 0}, {800, 450}), 1000) << "exactly behind";
}

}  // namespace
}  // namespace foveola
