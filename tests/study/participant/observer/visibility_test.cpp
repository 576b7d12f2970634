#include "study/participant/observer/visibility.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

constexpr Vision weber_vision{.decay_deg = 0.106,
                              .half_resolution_deg = 2.3,
                              .chromatic_decay_factor = 3.0,
                              .red_green_decades_per_deg = 0.04};

double linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// CIE 15: the cube root, with its straight beginning.
double compressed(double t) {
  constexpr double delta = 6.0 / 29.0;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
}

/// L*, a*, b* of an sRGB-encoded colour under D65, by the matrix of IEC 61966-2-1.
ChannelValues cielab(double red, double green, double blue) {
  const double r = linear(red);
  const double g = linear(green);
  const double b = linear(blue);
  const double x = compressed((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const double y = compressed(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = compressed((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.0890);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

TEST(OpponentChannels, DifferencesAreThoseOfCielabInJustNoticeableOnes) {
  constexpr double jnd_lab = 2.3;
  const double middle = 0.5;
  for (const Vec3 step : {Vec3(0.02F, 0.02F, 0.02F), Vec3(0.02F, 0.0F, 0.0F),
                          Vec3(0.0F, -0.02F, 0.0F), Vec3(0.01F, -0.01F, 0.02F)}) {
    const ChannelValues from = opponent_channels(Rgb(0.5F), jnd_lab);
    const ChannelValues to = opponent_channels(Rgb(0.5F) + step, jnd_lab);
    const ChannelValues lab_from = cielab(middle, middle, middle);
    const ChannelValues lab_to = cielab(middle + step.x, middle + step.y, middle + step.z);
    for (std::size_t channel = 0; channel < channel_count; ++channel) {
      EXPECT_NEAR(to[channel] - from[channel], (lab_to[channel] - lab_from[channel]) / jnd_lab,
                  0.04)
          << channel;
    }
  }
}

TEST(OpponentChannels, GreysHaveNoColourAndTheirLightnessKeepsWithin17PercentOfCielabs) {
  for (double grey = 0.2; grey < 0.99; grey += 0.1) {
    const auto encoded = static_cast<float>(grey);
    const ChannelValues values = opponent_channels(Rgb(encoded), 1.0);
    EXPECT_NEAR(values[1], 0.0, 1e-3);
    EXPECT_NEAR(values[2], 0.0, 1e-3);
    constexpr double step = 0.01;
    const double ours = opponent_channels(Rgb(encoded + 0.01F), 1.0)[0] - values[0];
    const double theirs =
        cielab(grey + step, grey + step, grey + step)[0] - cielab(grey, grey, grey)[0];
    EXPECT_NEAR(ours / theirs, 1.0, 0.17) << grey;
  }
}

// By hand: cells of 0.5 degrees make a period of 1 degree, so f = 1; exp(0.106 (1 + 10 / 2.3)) =
// exp(0.56687) = 1.76274; with 3 for 1, exp(0.77887) = 2.17901, and 10^0.4 = 2.51189 more for
// red-green. Cells of 2 degrees: f = 1/4, at 20 degrees exp(0.0265 (1 + 20 / 2.3)) = exp(0.256935)
// = 1.29296.
TEST(RelativeThreshold, IsTheFormulasValue) {
  EXPECT_NEAR(relative_threshold(weber_vision, Channel::achromatic, 0.5, 10.0), 1.76274, 1e-5);
  EXPECT_NEAR(relative_threshold(weber_vision, Channel::blue_yellow, 0.5, 10.0), 2.17901, 1e-5);
  EXPECT_NEAR(relative_threshold(weber_vision, Channel::red_green, 0.5, 10.0), 2.17901 * 2.51189,
              1e-4);
  EXPECT_NEAR(relative_threshold(weber_vision, Channel::achromatic, 2.0, 20.0), 1.29296, 1e-5);
}

TEST(RelativeThreshold, IsOneForLargeAreasAtTheGazeAndDoublesWhereTheExponentIsLn2) {
  for (const Channel channel : {Channel::achromatic, Channel::red_green, Channel::blue_yellow}) {
    EXPECT_NEAR(relative_threshold(weber_vision, channel, 1e6, 0.0), 1.0, 1e-6);
  }
  const double doubling_deg = (std::numbers::ln2 / 0.106 - 1.0) * 2.3;
  EXPECT_NEAR(relative_threshold(weber_vision, Channel::achromatic, 0.5, doubling_deg), 2.0, 1e-12);
}

// Mullen (1985): what luminance resolves at 34 cycles per degree, colour resolves at a third.
TEST(RelativeThreshold, ColourIsResolvedAtAThirdOfTheFrequency) {
  EXPECT_NEAR(relative_threshold(weber_vision, Channel::red_green, 0.5 / 12.0, 0.0),
              relative_threshold(weber_vision, Channel::achromatic, 0.5 / 36.0, 0.0), 1e-9);
}

TEST(VisibilityTable, IsTheInverseSquareOfTheThreshold) {
  const Visibility table(weber_vision, 0.5);
  for (double eccentricity_deg = 0.5; eccentricity_deg < 89.0; eccentricity_deg += 0.7) {
    const auto& visible = table.at(static_cast<float>(std::cos(radians(eccentricity_deg))));
    for (std::size_t channel = 0; channel < channel_count; ++channel) {
      const double threshold =
          relative_threshold(weber_vision, static_cast<Channel>(channel), 0.5, eccentricity_deg);
      EXPECT_NEAR(visible.at(channel) * threshold * threshold, 1.0, 0.01)
          << eccentricity_deg << " degrees, channel " << channel;
    }
  }
  EXPECT_NEAR(table.at(1.0F)[0], std::exp(-2.0 * 0.106), 1e-6);
  EXPECT_EQ(table.at(1.0F + 1e-6F)[0], table.at(1.0F)[0]) << "of rounded cosines too";

  EXPECT_EQ(table.at(-1.0F)[0], table.at(0.0F)[0]);
}

}  // namespace
}  // namespace foveola::study
