#include "renderer/image/tone_mapping.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace foveola {
namespace {

/// IEC 61966-2-1, of a value in [0, 1].
double standard(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

// Values of IEC 61966-2-1.
TEST(ToneMapping, FollowsTheStandard) {
  EXPECT_EQ(srgb_from_linear(0.0F), 0.0F);
  EXPECT_EQ(srgb_from_linear(1.0F), 1.0F);
  EXPECT_NEAR(srgb_from_linear(0.0031308F), 0.04045F, 1e-5F);
  EXPECT_NEAR(srgb_from_linear(0.21404114F), 0.5F, 1e-5F);
  EXPECT_NEAR(linear_from_srgb(0.5F), 0.21404114F, 1e-6F);
}

TEST(ToneMapping, IsWithinItsErrorEverywhere) {
  constexpr int steps = 1'000'000;
  for (int i = 0; i <= steps; ++i) {
    const float linear = static_cast<float>(i) / steps;
    const float encoded = srgb_from_linear(linear);
    ASSERT_NEAR(encoded, standard(linear), 5e-7) << linear;
    ASSERT_LE(encoded, 1.0F) << linear;
  }
}

TEST(ToneMapping, EightAtATimeAreAsOne) {
  const Floats linear{-1.0F, 0.0F, 0.001F, 0.0031308F, 0.2F, 0.999F, 1.0F, std::nanf("")};
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    EXPECT_EQ(srgb_from_linear(linear)[lane], srgb_from_linear(linear[lane])) << lane;
  }
}

TEST(ToneMapping, StaysInRangeWhateverComes) {
  EXPECT_EQ(srgb_from_linear(-1.0F), 0.0F);
  EXPECT_EQ(srgb_from_linear(std::numeric_limits<float>::infinity()), 1.0F);
  EXPECT_EQ(srgb_from_linear(std::nanf("")), 0.0F);
}

TEST(ToneMapping, ExposureIsInStops) {
  RgbImage image(1, 1);
  image.pixels = {Rgb(0.125F)};
  EXPECT_NEAR(display_image(image, 2.0).pixels[0].r, srgb_from_linear(0.5F), 1e-6F);
  EXPECT_NEAR(display_image(image, -1.0).pixels[0].r, srgb_from_linear(0.0625F), 1e-6F);
}

// The fit's rational function at 0.6 times the value, worked out by hand.
TEST(ToneMapping, TheFilmicCurveIsNarkowiczs) {
  EXPECT_EQ(filmic(0.0F), 0.0F);
  EXPECT_NEAR(filmic(0.18F), 0.0325163 / 0.2320635, 1e-5);
  EXPECT_NEAR(filmic(1.0F), 0.9216 / 1.3688, 1e-5);
  EXPECT_EQ(filmic(100.0F), 1.0F);
}

TEST(ToneMapping, TheFilmicCurveRisesAndStaysInRangeWhateverComes) {
  float before = 0.0F;
  for (float linear = 0.0F; linear < 50.0F; linear += 0.01F) {
    const float shown = filmic(linear);
    ASSERT_GE(shown, before) << linear;
    ASSERT_LE(shown, 1.0F) << linear;
    before = shown;
  }
  EXPECT_EQ(filmic(-1.0F), 0.0F);
  EXPECT_EQ(filmic(std::numeric_limits<float>::infinity()), 1.0F);
  EXPECT_EQ(filmic(std::nanf("")), 0.0F);
}

TEST(ToneMapping, TheFilmicCurveOfEightIsAsOfOne) {
  const Floats linear{-1.0F, 0.0F, 0.001F, 0.18F, 0.9F, 4.0F, 1e9F, std::nanf("")};
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    EXPECT_EQ(filmic(linear)[lane], filmic(linear[lane])) << lane;
  }
}

TEST(ToneMapping, AnImageIsShownByTheCurveAfterItsExposure) {
  RgbImage image(1, 1);
  image.pixels = {Rgb(0.5F, 1.0F, 2.0F)};
  const Rgb shown = display_image(image, 1.0, ToneCurve::filmic).pixels[0];
  EXPECT_EQ(shown.r, srgb_from_linear(filmic(1.0F)));
  EXPECT_EQ(shown.b, srgb_from_linear(filmic(4.0F)));
  EXPECT_EQ(display_image(image, 1.0).pixels[0].b, 1.0F);
}

}  // namespace
}  // namespace foveola
