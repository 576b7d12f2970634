#include <cmath>

#include "renderer/window/drawing/view_geometry.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

/// A window of 1000x500 pixels on it is 0.5 m wide, half a metre away.
DisplayProfile pane() {
  return {.kind = DisplayKind::monitor,
          .width_px = 2000,
          .height_px = 1000,
          .refresh_rate_hz = 60.0,
          .width_m = 1.0,
          .height_m = 0.5,
          .viewing_distance_m = 0.5};
}

TEST(WindowViewTest, ShowsWhatIsAskedForAcrossTheLargerSide) {
  WindowView view(pane(), 90.0, {1000, 500});
  EXPECT_NEAR(view.geometry().horizontal_fov_deg, 90.0, 1e-9);
  EXPECT_NEAR(view.geometry().vertical_fov_deg, degrees(2.0 * std::atan(0.5)), 1e-9);
  EXPECT_NEAR(view.times_true(), 2.0, 1e-9);  // tan 45 degrees over 0.25 / 0.5
  EXPECT_THAT(view.in_words(), HasSubstr("90.0 x 53.1 degrees, 2 times as wide"));
  view.resize({500, 1000});
  EXPECT_NEAR(view.geometry().vertical_fov_deg, 90.0, 1e-9);
}

TEST(WindowViewTest, TrueAnglesAreThoseOfThePane) {
  WindowView view(pane(), std::nullopt, {1000, 500});
  EXPECT_NEAR(view.geometry().horizontal_fov_deg, degrees(2.0 * std::atan(0.5)), 1e-9);
  EXPECT_EQ(view.times_true(), 1.0);
  EXPECT_THAT(view.in_words(), HasSubstr("true angles"));
  view.show_first();
  EXPECT_NEAR(view.geometry().horizontal_fov_deg, 60.0, 1e-9);
  view.show_true_angles();
  EXPECT_EQ(view.times_true(), 1.0);
}

TEST(WindowViewTest, ZoomsWithinLimits) {
  WindowView view(pane(), 60.0, {1000, 500});
  view.zoom(1.0);
  EXPECT_NEAR(std::tan(radians(0.5 * view.geometry().horizontal_fov_deg)),
              std::tan(radians(30.0)) / 1.1, 1e-9);
  view.zoom(-1.0);
  EXPECT_NEAR(view.geometry().horizontal_fov_deg, 60.0, 1e-9);
  view.zoom(1000.0);
  EXPECT_NEAR(view.geometry().horizontal_fov_deg, WindowView::narrowest_fov_deg, 1e-9);
  view.zoom(-1000.0);
  EXPECT_NEAR(view.geometry().horizontal_fov_deg, WindowView::widest_fov_deg, 1e-9);
  view.show_first();
  EXPECT_NEAR(view.geometry().horizontal_fov_deg, 60.0, 1e-9);
}

TEST(WindowViewTest, EyesAreMeasuredAtTrueAngles) {
  WindowView view(pane(), 90.0, {1000, 500});
  view.measure_eyes(true);
  EXPECT_EQ(view.times_true(), 1.0);
  view.measure_eyes(false);
  EXPECT_NEAR(view.geometry().horizontal_fov_deg, 90.0, 1e-9);
}

TEST(WindowViewTest, AHeadsetsViewsStay) {
  const DisplayProfile headset{.kind = DisplayKind::headset,
                               .width_px = 2560,
                               .height_px = 1440,
                               .refresh_rate_hz = 70.0,
                               .horizontal_fov_deg = 100.0,
                               .vertical_fov_deg = 90.0};
  const WindowView view(headset, 60.0, {1280, 720});
  EXPECT_FALSE(view.is_free());
  EXPECT_EQ(view.geometry().horizontal_fov_deg, 100.0);
  EXPECT_EQ(view.times_true(), 1.0);
}

TEST(WindowViewTest, TinyWindowsHaveViews) {
  WindowView view(pane(), 60.0, {100, 60});
  view.resize({2, 1});
  EXPECT_GT(view.geometry().vertical_fov_deg, 0.0);
}

}  // namespace
}  // namespace foveola
