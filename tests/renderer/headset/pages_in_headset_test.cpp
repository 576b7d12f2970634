// A page as both eyes of a headset see it: flat, far enough away, and nowhere near an edge.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/headset/headset_connection.h"
#include "tests/renderer/headset/saved_pictures.h"
#include "tests/renderer/headset/worn_headset.h"
#include "tests/x_server.h"

namespace foveola {
namespace {

struct HeadsetCase {
  const char* name;
  const char* eyes;
  double cant_deg;  ///< outwards
};

void PrintTo(const HeadsetCase& one, std::ostream* out) { *out << one.name; }

constexpr HeadsetCase headsets[] = {
    {"wide", R"([{"recommended_px": [720, 800], "cant_deg": 5, "offset_m": [-0.032, 0, 0],
                  "fov_deg": {"left": -54, "right": 44, "up": 50, "down": -53}},
                 {"recommended_px": [720, 800], "cant_deg": -5, "offset_m": [0.032, 0, 0],
                  "fov_deg": {"left": -44, "right": 54, "up": 50, "down": -53}}])",
     5.0},
    {"narrow", R"([{"recommended_px": [600, 500], "offset_m": [-0.032, 0, 0],
                    "fov_deg": {"left": -30, "right": 26, "up": 24, "down": -24}},
                   {"recommended_px": [600, 500], "offset_m": [0.032, 0, 0],
                    "fov_deg": {"left": -26, "right": 30, "up": 24, "down": -24}}])",
     0.0}};

/// What stands out from a page's dark ground.
struct Ink {
  Vec2 low{1.0F};  ///< in units of the picture, (0, 0) its top left
  Vec2 high{0.0F};
};

/// from and to: the part of the picture's width that is looked at.
Ink ink_in(const RgbImage& picture, float from = 0.0F, float to = 1.0F) {
  Ink ink;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Vec2 place = (Vec2(x, y) + 0.5F) / Vec2(picture.width, picture.height);
      if (picture.at(x, y).g > 0.4F && place.x >= from && place.x <= to) {
        ink.low = glm::min(ink.low, place);
        ink.high = glm::max(ink.high, place);
      }
    }
  }
  return ink;
}

class PagesInHeadset : public ::testing::TestWithParam<HeadsetCase> {
 protected:
  PagesInHeadset()
      : headset_(std::string(R"({"refresh_hz": 60, "save_pictures": true, "eyes": )") +
                 GetParam().eyes + "}") {}

  /// Both eyes' pictures, of one frame.
  std::array<RgbImage, 2> pictures_of(const ScreenPage& page) {
    worn_.show(page);
    const std::int64_t shown = headset_.newest_frame();
    test::wait_for_frame(headset_, shown + 3);
    return {test::saved_picture(headset_, shown + 2, 0),
            test::saved_picture(headset_, shown + 2, 1)};
  }

  /// An eye's view in the head.
  Viewport view_of(int eye) {
    const double outwards_deg = GetParam().cant_deg * (eye == 0 ? -1.0 : 1.0);
    return viewport_of(head_orientation({.azimuth_rad = radians(outwards_deg)}),
                       worn_.presenter().facts().eyes[static_cast<std::size_t>(eye)]);
  }

  test::XServer server_;
  test::ScriptedHeadset headset_;
  test::WornHeadset worn_;
};

/// The ends of what stands in a picture's outermost letters on the left, above and below, and then
/// of those on the right.
std::array<Vec2, 4> corners_in(const RgbImage& picture) {
  constexpr float letter = 0.02F;
  const Ink all = ink_in(picture);
  const Ink left = ink_in(picture, all.low.x, all.low.x + letter);
  const Ink right = ink_in(picture, all.high.x - letter, all.high.x);
  return {left.low, Vec2(left.low.x, left.high.y), Vec2(right.high.x, right.low.y), right.high};
}

// Where what both eyes see is, by their lines of sight: at each corner, without which it would be
// bent, and one eye would see it higher than the other.
TEST_P(PagesInHeadset, StandFlatAsFarAwayAsEyesRestAndNearNoEdge) {
  const ScreenPage page{.paragraphs = {std::string(200, 'x')}, .keys = std::string(30, 'x')};
  const std::array<RgbImage, 2> pictures = pictures_of(page);
  std::array<std::array<Vec2, 4>, 2> on_plane;  // at distance 1 ahead of the head
  for (int eye = 0; eye < 2; ++eye) {
    const std::array<Vec2, 4> corners = corners_in(pictures[static_cast<std::size_t>(eye)]);
    const Viewport view = view_of(eye);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 direction = view.direction(corners[i]);
      const Vec2 edge(corners[i].x < 0.5F ? 0.0F : 1.0F, corners[i].y < 0.5F ? 0.0F : 1.0F);
      EXPECT_GT(degrees(angle_between(direction, view.direction({edge.x, corners[i].y}))), 5.0);
      EXPECT_GT(degrees(angle_between(direction, view.direction({corners[i].x, edge.y}))), 5.0);
      on_plane[static_cast<std::size_t>(eye)][i] = Vec2(direction) / -direction.z;
    }
  }
  const HeadsetFacts& facts = worn_.presenter().facts();
  const double pixel_deg = facts.eyes[0].vertical_deg / facts.eye_px[0].y;
  for (std::size_t i = 0; i < on_plane[0].size(); ++i) {
    const Vec2 left = on_plane[0][i];
    const Vec2 right = on_plane[1][i];
    EXPECT_NEAR(0.064 / static_cast<double>(left.x - right.x), HeadsetConnection::page_distance_m,
                0.15);
    EXPECT_NEAR(degrees(std::atan(left.y) - std::atan(right.y)), 0.0, 1.5 * pixel_deg);
  }
}

INSTANTIATE_TEST_SUITE_P(Headsets, PagesInHeadset, ::testing::ValuesIn(headsets),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace foveola
