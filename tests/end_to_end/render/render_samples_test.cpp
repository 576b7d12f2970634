// Where the samples of the render command fall.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/image/image_file.h"
#include "renderer/view/equirect.h"
#include "renderer/view/viewport.h"
#include "tests/end_to_end/render/rendered_room.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

// All samples of a view of 60 x 30 degrees lie within 15 degrees of the horizon, a pixel's height
// aside, and some near its edges.
TEST_F(Render, AViewHasTwoFieldsOfView) {
  ASSERT_EQ(render("a.exr", {"--size", "128x64", "--samples", "20000", "--method", "vp", "--head",
                             "0,0", "--fov", "60x30"})
                .exit_code,
            0);
  const FilmImage image = read_film_image(folder_ / "a.exr");
  const auto row_has_samples = [&](int y) {
    return std::any_of(image.samples.begin() + y * 128, image.samples.begin() + (y + 1) * 128,
                       [](std::uint32_t count) { return count > 0; });
  };
  // Rows are 2.8125 degrees high: 15 degrees above the horizon is in row 32 - 6 = 26.
  EXPECT_TRUE(row_has_samples(26));
  EXPECT_FALSE(row_has_samples(25));
  EXPECT_FALSE(row_has_samples(38));
}

TEST_F(Render, FvSamplesFollowTheGazeAndVpSamplesStayInTheView) {
  const std::vector<std::string> options = {"--size", "128x64", "--samples", "100000",
                                            "--head", "170,0",  "--gaze",    "-175,20",
                                            "--fov",  "60",     "--method"};
  const Vec3 gaze =
      direction_from({.azimuth_rad = radians(-175.0), .elevation_rad = radians(20.0)});
  const Viewport view(head_orientation({.azimuth_rad = radians(170.0), .elevation_rad = 0.0}),
                      radians(64.0),
                      radians(64.0));  // one pixel more on each side
  for (const std::string method : {"fv", "vp"}) {
    std::vector<std::string> arguments = options;
    arguments.push_back(method);
    succeeded(render(method + ".exr", arguments));
    const FilmImage image = read_film_image(folder_ / (method + ".exr"));
    std::uint64_t total = 0;
    std::uint64_t expected_place = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 128; ++x) {
        const Vec3 direction = direction_from_equirect({(x + 0.5) / 128.0, (y + 0.5) / 64.0});
        const std::uint32_t count = image.samples[static_cast<std::size_t>(y) * 128 + x];
        total += count;
        const bool inside = method == "fv" ? degrees(angle_between(direction, gaze)) < 20.0
                                           : view.project(direction).has_value();
        expected_place += inside ? count : 0;
      }
    }
    EXPECT_EQ(total, 100000U);
    // Of the density 2 pi e m(e), 480.00 of 1091.85 lie within 20 degrees (trapezoid rule).
    const double fraction = static_cast<double>(expected_place) / static_cast<double>(total);
    if (method == "fv") {
      EXPECT_NEAR(fraction, 480.00 / 1091.85, 0.03);
    } else {
      EXPECT_EQ(fraction, 1.0);
    }
  }
}

}  // namespace
}  // namespace foveola::test
