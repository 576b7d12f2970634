// Pages as both eyes of a headset see them: large enough, far enough away, and nowhere near an
// edge.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/headset/headset_connection.h"
#include "renderer/window/screen_layout.h"
#include "tests/renderer/headset/saved_pictures.h"
#include "tests/renderer/headset/worn_headset.h"
#include "tests/renderer/window/sample_screens.h"
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

/// A picture's luminance, in [0, 1].
struct Luminance {
  int width = 0;
  int height = 0;
  std::vector<double> pixels;  ///< row by row
  double ground = 1.0;         ///< the darkest pixel's
};

Luminance luminance_of(const RgbImage& srgb) {
  static const auto linear = [] {
    std::array<double, 256> levels{};
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double value = static_cast<double>(i) / 255.0;
      levels[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    }
    return levels;
  }();
  const auto level = [](float value) {
    return linear[static_cast<std::size_t>(std::lround(255.0F * value))];
  };
  Luminance luminance{.width = srgb.width, .height = srgb.height};
  luminance.pixels.reserve(srgb.pixels.size());
  for (const Rgb& pixel : srgb.pixels) {
    luminance.pixels.push_back(0.2126 * level(pixel.r) + 0.7152 * level(pixel.g) +
                               0.0722 * level(pixel.b));
    luminance.ground = std::min(luminance.ground, luminance.pixels.back());
  }
  return luminance;
}

/// What stands out from a page's ground.
struct Ink {
  Vec2 low{1.0F};  ///< in units of the picture, (0, 0) its top left
  Vec2 high{0.0F};
  double brightest = 0.0;  ///< luminance
};

/// WCAG 2.1's.
double contrast(double bright, double dark) { return (bright + 0.05) / (dark + 0.05); }

/// from and to: the part of the picture's width that is looked at.
Ink ink_in(const Luminance& picture, float from = 0.0F, float to = 1.0F) {
  Ink ink;
  const double* pixel = picture.pixels.data();
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const double luminance = *pixel++;
      if (contrast(luminance, picture.ground) <= 1.5) {
        continue;
      }
      const Vec2 place = (Vec2(x, y) + 0.5F) / Vec2(picture.width, picture.height);
      if (place.x >= from && place.x <= to) {
        ink.low = glm::min(ink.low, place);
        ink.high = glm::max(ink.high, place);
        ink.brightest = std::max(ink.brightest, luminance);
      }
    }
  }
  return ink;
}

class PagesInHeadset : public ::testing::TestWithParam<HeadsetCase> {
 protected:
  PagesInHeadset()
      : headset_(R"({"refresh_hz": 60, "save_frames": )" + test::all_frames() + R"(, "eyes": )" +
                 GetParam().eyes + "}") {}

  /// Both eyes' pictures, of one frame.
  std::array<Luminance, 2> pictures_of(const ScreenPage& page) {
    worn_.show(page);
    const std::int64_t shown = test::newest_frame(headset_);
    test::wait_for_frame(headset_, shown + 3);
    return {luminance_of(test::saved_picture(headset_, shown + 2, 0)),
            luminance_of(test::saved_picture(headset_, shown + 2, 1))};
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

TEST_P(PagesInHeadset, StandOutAndEndFiveDegreesBeforeTheEdges) {
  for (const test::SampleScreen& sample : test::sample_screens()) {
    if (!sample.screen.covers_picture || sample.screen.is_signal) {
      continue;
    }
    SCOPED_TRACE(sample.name);
    const std::array<Luminance, 2> pictures = pictures_of(sample.screen);
    for (int eye = 0; eye < 2; ++eye) {
      const Luminance& picture = pictures[static_cast<std::size_t>(eye)];
      const Ink ink = ink_in(picture);
      const Viewport view = view_of(eye);
      const auto gap_deg = [&](const Vec2& from, const Vec2& to) {
        return degrees(angle_between(view.direction(from), view.direction(to)));
      };
      const Vec2 middle = 0.5F * (ink.low + ink.high);
      EXPECT_GT(gap_deg({ink.low.x, middle.y}, {0.0F, middle.y}), 5.0);
      EXPECT_GT(gap_deg({ink.high.x, middle.y}, {1.0F, middle.y}), 5.0);
      EXPECT_GT(gap_deg({middle.x, ink.low.y}, {middle.x, 0.0F}), 5.0);
      EXPECT_GT(gap_deg({middle.x, ink.high.y}, {middle.x, 1.0F}), 5.0);
      EXPECT_GT(contrast(ink.brightest, picture.ground), 7.0);
    }
  }
}

// Reading is fluent from 0.2 degrees on (see text_height_px).
TEST_P(PagesInHeadset, HaveLettersThatAreLargeEnough) {
  const ScreenPage page{.paragraphs = {"xxxxxxxx"}};
  const Luminance picture = pictures_of(page)[0];
  const Ink ink = ink_in(picture);
  const Viewport view = view_of(0);
  const float x = 0.5F * (ink.low.x + ink.high.x);
  const float half_pixel = 0.5F / static_cast<float>(picture.height);
  const double height_deg = degrees(angle_between(view.direction({x, ink.low.y - half_pixel}),
                                                  view.direction({x, ink.high.y + half_pixel})));
  EXPECT_GT(height_deg, 0.4);
  EXPECT_LT(height_deg, 2.0);
}

/// The ends of what stands in a picture's outermost letters on the left, above and below, and then
/// of those on the right.
std::array<Vec2, 4> corners_in(const Luminance& picture) {
  constexpr float letter = 0.02F;
  const Ink all = ink_in(picture);
  const Ink left = ink_in(picture, all.low.x, all.low.x + letter);
  const Ink right = ink_in(picture, all.high.x - letter, all.high.x);
  return {left.low, Vec2(left.low.x, left.high.y), Vec2(right.high.x, right.low.y), right.high};
}

// Where what both eyes see is, by their lines of sight: at each corner, without which it would be
// bent, and one eye would see it higher than the other.
TEST_P(PagesInHeadset, StandFlatAsFarAwayAsEyesRest) {
  const ScreenPage page{.paragraphs = {std::string(200, 'x')}, .keys = std::string(30, 'x')};
  const std::array<Luminance, 2> pictures = pictures_of(page);
  std::array<std::array<Vec2, 4>, 2> on_plane;  // at distance 1 ahead of the head
  for (int eye = 0; eye < 2; ++eye) {
    const std::array<Vec2, 4> corners = corners_in(pictures[static_cast<std::size_t>(eye)]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 direction = view_of(eye).direction(corners[i]);
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
