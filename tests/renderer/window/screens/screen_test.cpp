// Screens as they are drawn. With FOVEOLA_SCREENS=FOLDER every capture is written there, for people
// to look at.
#include "renderer/window/screens/screen.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/renderer/window/sample_screens.h"
#include "tests/renderer/window/screen_capture.h"

namespace foveola {
namespace {

using test::is_ink;

class ScreenTest : public ::testing::TestWithParam<test::WindowCase> {
 protected:
  RgbImage capture(const std::optional<ScreenPage>& screen) { return screens_.capture(screen); }

  test::ScreenCapture screens_{GetParam()};
};

int count_pixels(const RgbImage& picture, const std::function<bool(const Rgb&)>& is_counted) {
  return static_cast<int>(std::count_if(picture.pixels.begin(), picture.pixels.end(), is_counted));
}

TEST_P(ScreenTest, IsDrawnInsideTheWindow) {
  for (const test::SampleScreen& sample : test::sample_screens()) {
    SCOPED_TRACE(sample.name);
    const RgbImage picture = capture(sample.screen);
    test::keep_for_people(fmt::format("{}-{}", GetParam().name, sample.name), picture);
    const Ink ground = sample.screen.is_signal ? Ink::text : Ink::ground;
    const Ink text = sample.screen.is_signal ? Ink::ground : Ink::text;
    if (sample.screen.covers_picture) {
      EXPECT_EQ(test::strangers_in_margin(picture, ground), 0);
    }
    const float text_px = static_cast<float>(GetParam().size.y) / 56.0F;
    EXPECT_GT(count_pixels(picture, [&](const Rgb& color) { return is_ink(color, text); }),
              text_px * text_px);
  }
}

TEST_P(ScreenTest, ABandLeavesThePictureAsItIs) {
  const RgbImage plain = capture(std::nullopt);
  const RgbImage banded = capture(ScreenPage{.title = "Taken", .covers_picture = false});
  const auto dark = [](const Rgb& color) { return color.g < 0.5F; };
  EXPECT_EQ(count_pixels(plain, dark), 0);
  const int changed = count_pixels(banded, dark);
  EXPECT_GT(changed, 0.02 * static_cast<double>(banded.pixels.size()));
  EXPECT_LT(changed, 0.15 * static_cast<double>(banded.pixels.size()));
  for (int y = 0; y < banded.height / 2; ++y) {
    for (int x = 0; x < banded.width; ++x) {
      ASSERT_EQ(banded.at(x, y), plain.at(x, y));
    }
  }
}

TEST_P(ScreenTest, LettersFollowTheWindowsSize) {
  const ScreenPage screen{.title = "Large", .paragraphs = {"and small"}};
  const RgbImage large = capture(screen);
  const RgbImage small = screens_.capture(screen, GetParam().size / 2);
  test::keep_for_people(fmt::format("{}-half", GetParam().name), small);
  EXPECT_EQ(capture(screen).pixels, large.pixels);
  const auto bright = [](const Rgb& color) { return color.g > 0.5F; };
  EXPECT_NEAR(static_cast<double>(count_pixels(large, bright)) / count_pixels(small, bright), 4.0,
              0.8);  // heights are rounded to pixels
}

TEST_P(ScreenTest, BothEyesSeeTheSame) {
  if (!GetParam().is_headset) {
    GTEST_SKIP() << "one view";
  }
  const RgbImage picture = capture(test::sample_screens().front().screen);
  const int half = picture.width / 2;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < half; ++x) {
      // Edges between pixels are rounded anew.
      ASSERT_LT(max_component(glm::abs(picture.at(x, y) - picture.at(x + half, y))), 0.04F);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ScreenTest, ::testing::ValuesIn(test::window_cases),
                         [](const auto& one) { return fmt::format("Window{}", one.param.name); });

}  // namespace
}  // namespace foveola
