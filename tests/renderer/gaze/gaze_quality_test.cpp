#include "renderer/gaze/gaze_quality.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

/// Angles from straight ahead to a sample, in degrees; empty: it is lost.
using Gaze = std::function<std::optional<DVec2>(int index)>;

/// So many samples of a target that is straight ahead.
WatchedTarget watched(const Gaze& gaze, int count, double rate_hz = 120.0) {
  const Nanoseconds interval = nanoseconds_from_seconds(1.0 / rate_hz);
  WatchedTarget target{.start = interval, .end = (count + 1) * interval};
  for (int i = 0; i < count; ++i) {
    GazeSample sample{.time = target.start + i * interval};
    if (const std::optional<DVec2> angles = gaze(i)) {
      sample.direction =
          direction_from({.azimuth_rad = radians(angles->x), .elevation_rad = radians(angles->y)});
      sample.valid = true;
    }
    target.samples.push_back(sample);
  }
  return target;
}

GazeQuality quality_of(const WatchedTarget& target) { return gaze_quality(std::span(&target, 1)); }

Gaze steady(double right_deg, double up_deg) {
  return [=](int) { return DVec2(right_deg, up_deg); };
}

/// Noise of this deviation along each axis.
Gaze noisy(double right_deg, double noise_deg, std::uint64_t seed) {
  return [=, random = Pcg32(seed)](int) mutable {
    const double right = right_deg + noise_deg * random.normal();
    const double up = noise_deg * random.normal();
    return std::optional(DVec2(right, up));
  };
}

TEST(GazeQuality, OfAPerfectTracker) {
  const GazeQuality quality = quality_of(watched(steady(0.0, 0.0), 120));
  ASSERT_TRUE(quality.figures);
  EXPECT_EQ(quality.figures->accuracy_deg, 0.0);
  EXPECT_EQ(quality.figures->precision_rms_deg, 0.0);
  EXPECT_EQ(quality.figures->precision_sd_deg, 0.0);
  EXPECT_EQ(quality.data_loss, 0.0);
}

// The hypotenuse of a right triangle on the sphere.
TEST(GazeQuality, AccuracyIsTheTrueAngleOfAnOffset) {
  const GazeQuality quality = quality_of(watched(steady(3.0, -4.0), 120));
  const double expected_deg = degrees(std::acos(std::cos(radians(3.0)) * std::cos(radians(4.0))));
  EXPECT_NEAR(quality.figures->accuracy_deg, expected_deg, 1e-4);
  EXPECT_NEAR(quality.figures->precision_sd_deg, 0.0, 1e-4);
  const AzimuthElevation mean = azimuth_elevation(quality.targets.at(0).seen->mean_gaze);
  EXPECT_NEAR(degrees(mean.azimuth_rad), 3.0, 1e-4);
  EXPECT_NEAR(degrees(mean.elevation_rad), -4.0, 1e-4);
}

// Distances of two normal numbers: Rayleigh's mean s sqrt(pi / 2), the root mean square sqrt(2) s,
// and between two of them sqrt(2) as much, 2 s.
TEST(GazeQuality, OfWhiteNoise) {
  const double s = 0.2;
  for (const double rate_hz : {60.0, 120.0, 1000.0}) {
    const GazeQuality quality = quality_of(watched(noisy(0.0, s, 5), 40'000, rate_hz));
    ASSERT_TRUE(quality.figures);
    EXPECT_NEAR(quality.figures->accuracy_deg, s * std::sqrt(0.5 * std::numbers::pi), 0.003);
    EXPECT_NEAR(quality.figures->precision_rms_deg, 2.0 * s, 0.004) << rate_hz;
    EXPECT_NEAR(quality.figures->precision_sd_deg, std::sqrt(2.0) * s, 0.003);
    EXPECT_NEAR(static_cast<double>(quality.targets.at(0).seen->samples), 40'000.0, 2.0);
  }
}

// Rice's mean for an offset b that is large beside the noise: b + s^2 / (2 b).
TEST(GazeQuality, OfAnOffsetWithNoise) {
  const GazeQuality quality = quality_of(watched(noisy(1.0, 0.2, 6), 40'000));
  EXPECT_NEAR(quality.figures->accuracy_deg, 1.02, 0.005);
  EXPECT_NEAR(quality.figures->precision_sd_deg, std::sqrt(2.0) * 0.2, 0.003);
}

TEST(GazeQuality, PrecisionsDistinguishTremorFromDrift) {
  const auto trembling = [](int i) { return DVec2(i % 2 == 0 ? 0.1 : -0.1, 0.0); };
  const GazeFigures fast = *quality_of(watched(trembling, 121)).figures;
  EXPECT_NEAR(fast.precision_rms_deg, 0.2, 1e-4);
  EXPECT_NEAR(fast.precision_sd_deg, 0.1, 1e-4);
  const auto drifting = [](int i) { return DVec2(0.01 * i, 0.0); };
  const GazeFigures slow = *quality_of(watched(drifting, 121)).figures;
  EXPECT_NEAR(slow.precision_rms_deg, 0.01, 1e-4);
  // Of the numbers 1 to 120, in hundredths: sqrt((120^2 - 1) / 12).
  EXPECT_NEAR(slow.precision_sd_deg, 0.3464, 1e-3);
}

TEST(GazeQuality, SaccadesAreLeftOut) {
  const auto glance_away = [](int i) {
    const double away_deg[] = {2.0, 4.0, 2.0};
    return DVec2(i >= 50 && i < 53 ? away_deg[i - 50] : 0.0, 0.0);
  };
  const GazeQuality quality = quality_of(watched(glance_away, 120));
  EXPECT_EQ(quality.figures->accuracy_deg, 0.0);
  EXPECT_EQ(quality.figures->precision_rms_deg, 0.0);
  // All but the first, of which no velocity is known, and the four that moved.
  EXPECT_EQ(quality.targets.at(0).seen->samples, 115U);
  EXPECT_EQ(quality.data_loss, 0.0);
}

TEST(GazeQuality, WhereASaccadeLedIsNoStepFromWhereItBegan) {
  const auto look_on = [](int i) { return DVec2(i < 60 ? 0.0 : i < 62 ? 2.0 : 4.0, 0.0); };
  const GazeFigures figures = *quality_of(watched(look_on, 121)).figures;
  EXPECT_EQ(figures.precision_rms_deg, 0.0);
  // Of 59 samples each at 0, at 2 after its saccade, and at 4 after its: 1, and 58.
  EXPECT_NEAR(figures.accuracy_deg, (2.0 + 4.0 * 58.0) / (59.0 + 1.0 + 58.0), 1e-4);
}

TEST(GazeQuality, LostIsWhatIsInvalidAndWhatNeverCame) {
  const auto three_of_ten_lost = [](int i) {
    return i % 10 < 3 ? std::nullopt : std::optional(DVec2(0.0));
  };
  WatchedTarget target = watched(three_of_ten_lost, 200);
  EXPECT_NEAR(quality_of(target).data_loss, 0.3, 1e-6);
  std::erase_if(target.samples, [](const GazeSample& sample) { return !sample.valid; });
  EXPECT_NEAR(quality_of(target).data_loss, 0.3, 1e-6);
}

TEST(GazeQuality, ATargetThatWasHardlySeenHasNoFigures) {
  const auto nothing = [](int) { return std::nullopt; };
  const GazeQuality unseen = quality_of(watched(nothing, 200));
  EXPECT_EQ(unseen.data_loss, 1.0);
  EXPECT_FALSE(unseen.figures);
  EXPECT_FALSE(unseen.targets.at(0).seen);
  const auto five = [](int i) { return i < 5 ? std::optional(DVec2(0.0)) : std::nullopt; };
  EXPECT_FALSE(quality_of(watched(five, 200)).figures);
  const WatchedTarget silent{.start = Nanoseconds(0), .end = std::chrono::seconds(3)};
  EXPECT_EQ(quality_of(silent).data_loss, 1.0);
  EXPECT_FALSE(quality_of(silent).figures);
}

TEST(GazeQuality, OfSeveralTargetsIsTheirMean) {
  const auto nothing = [](int) { return std::nullopt; };
  const std::vector<WatchedTarget> targets = {
      watched(steady(1.0, 0.0), 120), watched(steady(0.0, 3.0), 120), watched(nothing, 120)};
  const GazeQuality quality = gaze_quality(targets);
  EXPECT_NEAR(quality.figures->accuracy_deg, 2.0, 1e-4);
  EXPECT_NEAR(quality.data_loss, 1.0 / 3.0, 1e-6);
  EXPECT_EQ(quality.targets.size(), 3U);
}

TEST(GazeGate, RefusesWhatIsWorse) {
  const GazeQuality quality{.targets = {{.data_loss = 0.1, .seen = SeenTarget{}}},
                            .data_loss = 0.1,
                            .figures = GazeFigures{.accuracy_deg = 1.0, .precision_rms_deg = 0.4}};
  const GazeGate exact{.max_accuracy_deg = 1.0, .max_precision_deg = 0.4, .max_data_loss = 0.1};
  EXPECT_TRUE(passes(quality, exact));
  GazeGate stricter = exact;
  stricter.max_accuracy_deg = 0.99;
  EXPECT_FALSE(passes(quality, stricter));
  stricter = exact;
  stricter.max_precision_deg = 0.39;
  EXPECT_FALSE(passes(quality, stricter));
  stricter = exact;
  stricter.max_data_loss = 0.09;
  EXPECT_FALSE(passes(quality, stricter));
  GazeQuality with_gap = quality;
  with_gap.targets.push_back({});
  EXPECT_FALSE(passes(with_gap, exact));
}

using std::chrono::milliseconds;

GazeSample sample_at(int time_ms, bool valid = true) {
  return {.time = milliseconds(time_ms), .valid = valid};
}

TEST(InterSampleIntervals, CountsEverySampleOnce) {
  InterSampleIntervals intervals;
  for (const int time_ms : {0, 10, 10, 10, 20, 15, 30}) {
    intervals.add(sample_at(time_ms, time_ms != 20));
  }
  EXPECT_EQ(intervals.samples(), 4U);
  EXPECT_EQ(intervals.valid_samples(), 3U);
  EXPECT_EQ(intervals.gaps(), 0U);
  EXPECT_DOUBLE_EQ(*intervals.rate_hz(), 100.0);
  EXPECT_NEAR(*intervals.jitter_ms(), 0.0, 1e-9);
}

TEST(InterSampleIntervals, ReportsGapsAndJitter) {
  InterSampleIntervals intervals;
  for (const int time_ms : {0, 10, 19, 30, 40, 70, 80}) {
    intervals.add(sample_at(time_ms));
  }
  EXPECT_EQ(intervals.gaps(), 1U);
  EXPECT_DOUBLE_EQ(*intervals.rate_hz(), 100.0);
  EXPECT_NEAR(*intervals.jitter_ms(), (0 + 1 + 1 + 0 + 20 + 0) / 6.0, 1e-9);
}

TEST(InterSampleIntervals, ForgetsAnOldRate) {
  InterSampleIntervals intervals;
  int time_ms = 0;
  for (int i = 0; i < 300; ++i) {
    intervals.add(sample_at(time_ms += 10));
  }
  for (std::size_t i = 0; i < InterSampleIntervals::window; ++i) {
    intervals.add(sample_at(time_ms += 5));
  }
  EXPECT_DOUBLE_EQ(*intervals.rate_hz(), 200.0);
}

}  // namespace

}  // namespace foveola
