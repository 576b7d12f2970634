#include "scenes/modelling/patterns.h"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace foveola::scenes {
namespace {

int green(const Image& image, int x, int y) {
  return image.rgba[4U * static_cast<std::size_t>(y * image.width + x) + 1U];
}

/// The mean step between neighbours in x, inside the image and over its left and right edges.
struct Steps {
  double inside = 0.0;
  double over_the_edge = 0.0;
};

Steps steps_across(const Image& image) {
  Steps steps;
  for (int y = 0; y < image.height; ++y) {
    steps.over_the_edge += std::abs(green(image, 0, y) - green(image, image.width - 1, y));
    for (int x = 1; x < image.width; ++x) {
      steps.inside += std::abs(green(image, x, y) - green(image, x - 1, y));
    }
  }
  steps.over_the_edge /= image.height;
  steps.inside /= static_cast<double>(image.height) * (image.width - 1);
  return steps;
}

TEST(Patterns, PlasterRepeatsWithoutASeam) {
  const Steps steps = steps_across(plaster(128, Rgb(0.5F), 0.5, Seed(3)));
  EXPECT_GT(steps.inside, 0.0);
  EXPECT_LT(steps.over_the_edge, 2.0 * steps.inside);
}

TEST(Patterns, MasonryRepeatsWithoutASeam) {
  const Steps steps = steps_across(
      masonry(256, {.courses = 8, .stones = 4, .joint = 0.1, .variation = 0.3}, Seed(3)));
  EXPECT_LT(steps.over_the_edge, 3.0 * steps.inside);
}

TEST(Patterns, PlainPlasterHasTheSrgbValueOfItsColour) {
  // Linear 0.5 is 188 of 255 in sRGB (IEC 61966-2-1).
  const Image image = plaster(8, Rgb(0.5F), 0.0, Seed(1));
  EXPECT_EQ(green(image, 3, 3), 188);
  EXPECT_EQ(image.rgba[3], 255);
}

TEST(Patterns, LeafIsPartlyTransparentAndItsBorderIsAllTransparent) {
  const Image image = leaf(64, {0.1F, 0.3F, 0.05F}, Seed(5));
  std::size_t opaque = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const int alpha = image.rgba[4U * static_cast<std::size_t>(y * 64 + x) + 3U];
      opaque += alpha == 255 ? 1 : 0;
      EXPECT_TRUE(alpha == 0 || alpha == 255);
      EXPECT_FALSE(alpha == 255 && (x == 0 || x == 63 || y == 0));
    }
  }
  EXPECT_GT(opaque, 64U * 64U / 5U);
  EXPECT_LT(opaque, 64U * 64U / 2U);
}

TEST(Patterns, SeedsMakeADifference) {
  const auto planks = [](const Seed& seed) { return wood(32, 4, Rgb(0.4F), Rgb(0.2F), seed).rgba; };
  EXPECT_EQ(planks(Seed(1)), planks(Seed(1)));
  EXPECT_NE(planks(Seed(1)), planks(Seed(2)));
}

TEST(Patterns, BoardIsTwiceAsWideAsHighAndWrittenOn) {
  const Image image = written_board(64, Seed(1));
  EXPECT_EQ(image.width, 128);
  EXPECT_EQ(image.height, 64);
  int dark = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 128; ++x) {
      dark += green(image, x, y) < 100 ? 1 : 0;
    }
  }
  EXPECT_GT(dark, 200);
  EXPECT_LT(dark, 64 * 128 / 3);
}

TEST(Patterns, ClockShowsTenPastTen) {
  const Image image = clock_face(200);
  // The hands point to the upper left and the upper right; nothing points down.
  EXPECT_LT(green(image, 100 + 30, 100 - 17), 60);
  EXPECT_LT(green(image, 100 - 30, 100 - 21), 60);
  EXPECT_GT(green(image, 100, 140), 180);
}

}  // namespace
}  // namespace foveola::scenes
