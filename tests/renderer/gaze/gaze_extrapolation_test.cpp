#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/gaze/gaze_filter.h"
#include "renderer/gaze/rotations.h"
#include "renderer/gaze/simulated_eye.h"
#include "tests/renderer/gaze/gaze_expectations.h"

namespace foveola {
namespace {

constexpr double rate_hz = 120.0;
constexpr Nanoseconds default_horizon = std::chrono::milliseconds(30);
constexpr double horizon_s = 0.03;

/// Azimuth and elevation in degrees.
Vec3 towards_deg(const DVec2& angles_deg) { return test::at_deg(angles_deg.x, angles_deg.y); }
DVec2 angles_in_deg(const Vec3& direction) {
  const AzimuthElevation angles = azimuth_elevation(direction);
  return {degrees(angles.azimuth_rad), degrees(angles.elevation_rad)};
}

GazeSample valid_at(double time_s, const DVec2& angles_deg) {
  return {.time = nanoseconds_from_seconds(time_s),
          .direction = towards_deg(angles_deg),
          .valid = true};
}

/// Samples at `rate_hz` of an eye that is at azimuth_deg(t) until `duration_s`, with noise along
/// each axis.
std::vector<GazeSample> samples_of(const std::function<double(double)>& azimuth_deg,
                                   double duration_s, double noise_deg = 0.0) {
  Pcg32 random(11);
  std::vector<GazeSample> samples;
  for (int i = 0; i / rate_hz < duration_s; ++i) {
    const DVec2 noise(noise_deg * random.normal(), noise_deg * random.normal());
    samples.push_back(valid_at(i / rate_hz, DVec2(azimuth_deg(i / rate_hz), 0.0) + noise));
  }
  return samples;
}

double time_s_of(std::size_t sample) { return static_cast<double>(sample) / rate_hz; }

double pursuit_deg(double time_s) { return 20.0 * time_s - 15.0; }

std::vector<Vec3> all_extrapolated(const std::vector<GazeSample>& samples,
                                   Nanoseconds horizon = default_horizon) {
  GazeExtrapolation extrapolation(horizon);
  std::vector<Vec3> directions;
  for (const GazeSample& sample : samples) {
    directions.push_back(extrapolation.extrapolated(sample));
  }
  return directions;
}

TEST(GazeExtrapolation, IsWhereAPursuingEyeWillBe) {
  const std::vector<GazeSample> samples = samples_of(pursuit_deg, 1.5);
  const std::vector<Vec3> later = all_extrapolated(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    // Five intervals are the first of 40 ms and more.
    const double expected_deg =
        i < 5 ? pursuit_deg(time_s_of(i)) : pursuit_deg(time_s_of(i) + horizon_s);
    EXPECT_NEAR(angles_in_deg(later[i]).x, expected_deg, 2e-4) << i;
    EXPECT_NEAR(angles_in_deg(later[i]).y, 0.0, 2e-4) << i;
  }
}

// On a great circle that is no parallel and no meridian.
TEST(GazeExtrapolation, GoesOnAlongAnyGreatCircle) {
  const DVec3 start = glm::normalize(DVec3(0.3, 0.8, -0.4));
  const DVec3 axis = glm::normalize(glm::cross(start, DVec3(0.5, -0.2, -0.9)));
  GazeExtrapolation extrapolation(default_horizon);
  const auto direction = [&](double time_s) {
    return Vec3(rotated(start, axis * (radians(30.0) * time_s)));
  };
  for (int i = 0; i < 60; ++i) {
    const Vec3 later = extrapolation.extrapolated({.time = nanoseconds_from_seconds(i / rate_hz),
                                                   .direction = direction(i / rate_hz),
                                                   .valid = true});
    if (i >= 5) {
      EXPECT_LT(degrees(angle_between(later, direction(i / rate_hz + horizon_s))), 1e-3) << i;
    }
  }
}

TEST(GazeExtrapolation, TakesIrregularIntervalsAsTheyAre) {
  Pcg32 random(3);
  GazeExtrapolation extrapolation(default_horizon);
  double time_s = 0.0;
  for (int i = 0; i < 200; ++i, time_s += 0.003 + 0.02 * random.uniform()) {
    const Vec3 later = extrapolation.extrapolated(valid_at(time_s, {pursuit_deg(time_s), 0.0}));
    if (i >= 20) {
      EXPECT_NEAR(angles_in_deg(later).x, pursuit_deg(time_s + horizon_s), 1e-3) << i;
    }
  }
}

/// The root mean square angle between the gaze and where the eye is `horizon_s` later.
double error_deg(const std::vector<Vec3>& gaze) {
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 20; i < gaze.size(); ++i, ++count) {
    const double angle_deg =
        degrees(angle_between(gaze[i], towards_deg({pursuit_deg(time_s_of(i) + horizon_s), 0.0})));
    squares += angle_deg * angle_deg;
  }
  return std::sqrt(squares / count);
}

// What the header states.
TEST(GazeExtrapolation, IsNearerToANoisyPursuitThanTheGazeItself) {
  const std::vector<GazeSample> samples = samples_of(pursuit_deg, 1.5, 0.1);
  std::vector<Vec3> seen;
  for (const GazeSample& sample : samples) {
    seen.push_back(sample.direction);
  }
  EXPECT_NEAR(error_deg(seen), 0.61, 0.02);
  EXPECT_NEAR(error_deg(all_extrapolated(samples)), 0.16, 0.02);
}

TEST(GazeExtrapolation, LeavesAnEyeAtRestWhereItIsSeen) {
  const std::vector<GazeSample> samples = samples_of([](double) { return 3.0; }, 60.0, 0.1);
  const std::vector<Vec3> later = all_extrapolated(samples);
  double squares_seen = 0.0;
  double squares = 0.0;
  double largest_turn_deg = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const DVec2 seen_deg = angles_in_deg(samples[i].direction) - DVec2(3.0, 0.0);
    const DVec2 later_deg = angles_in_deg(later[i]) - DVec2(3.0, 0.0);
    squares_seen += glm::dot(seen_deg, seen_deg);
    squares += glm::dot(later_deg, later_deg);
    largest_turn_deg =
        std::max(largest_turn_deg, degrees(angle_between(samples[i].direction, later[i])));
  }
  EXPECT_NEAR(std::sqrt(squares / squares_seen), 1.0, 0.005);
  EXPECT_LT(largest_turn_deg, 0.2);
}

TEST(GazeExtrapolation, TurnsByTwoDegreesAtMost) {
  const auto fast_deg = [](double time_s) { return 60.0 * time_s; };
  const std::vector<GazeSample> samples = samples_of(fast_deg, 0.5);
  const std::vector<Vec3> later = all_extrapolated(samples, longest_horizon);
  EXPECT_NEAR(degrees(angle_between(samples.back().direction, later.back())), 2.0, 1e-3);
}

/// How far the gaze at most is beyond the end of a saccade from azimuth 0, and before its start,
/// for samples that see it at any phase.
struct Overshoot {
  double end_deg = 0.0;
  double start_deg = 0.0;
};

Overshoot overshoot(double amplitude_deg) {
  Overshoot overshoot;
  for (double phase_s = 0.0; phase_s < 1.0 / rate_hz; phase_s += 1.0 / (32.0 * rate_hz)) {
    const auto azimuth_deg = [&](double time_s) {
      return saccade_progress_deg(amplitude_deg, time_s + phase_s - 0.4);
    };
    for (const Vec3& direction : all_extrapolated(samples_of(azimuth_deg, 0.8))) {
      overshoot.end_deg = std::max(overshoot.end_deg, angles_in_deg(direction).x - amplitude_deg);
      overshoot.start_deg = std::max(overshoot.start_deg, -angles_in_deg(direction).x);
    }
  }
  return overshoot;
}

TEST(GazeExtrapolation, ThrowsNothingBeyondTheEndOfASaccade) {
  for (const double amplitude_deg : {5.0, 10.0, 20.0}) {
    const Overshoot found = overshoot(amplitude_deg);
    EXPECT_LT(found.end_deg, 1e-3) << amplitude_deg;
    EXPECT_LT(found.start_deg, 1e-3) << amplitude_deg;
  }
}

// It is below the threshold of a saccade: seen as a pursuit for a moment.
TEST(GazeExtrapolation, GoesBeyondTheEndOfASmallSaccadeByAThirdAtMost) {
  for (const double amplitude_deg : {0.5, 1.0, 1.5, 2.0}) {
    const Overshoot found = overshoot(amplitude_deg);
    EXPECT_LT(found.end_deg, 0.31 * amplitude_deg);
    EXPECT_GT(found.end_deg, 0.1 * amplitude_deg);
    EXPECT_LT(found.start_deg, 1e-3);
  }
}

TEST(GazeExtrapolation, LeavesTheSamplesOfASaccadeAndTheFirstAfterIt) {
  std::vector<GazeSample> samples;
  for (int i = 0; i < 30; ++i) {
    const double step_deg = i < 20 ? 0.0 : 5.0;
    samples.push_back(valid_at(i / rate_hz, {pursuit_deg(i / rate_hz) + step_deg, 0.0}));
  }
  const std::vector<Vec3> later = all_extrapolated(samples);
  EXPECT_NE(later[19], samples[19].direction);
  for (std::size_t i = 20; i < 25; ++i) {
    EXPECT_EQ(later[i], samples[i].direction) << i;
  }
  EXPECT_NE(later[25], samples[25].direction);
}

/// Whether the sample after `pause_s` of a pursuit's is turned on.
bool goes_on_after(double pause_s, bool is_blink) {
  GazeExtrapolation extrapolation(default_horizon);
  for (int i = 0; i <= 12; ++i) {
    extrapolation.extrapolated(valid_at(i / rate_hz, {pursuit_deg(i / rate_hz), 0.0}));
  }
  const double last_s = 12.0 / rate_hz;
  const double next_s = last_s + pause_s;
  for (double time_s = last_s + 1.0 / rate_hz; is_blink && time_s < next_s - 0.001;
       time_s += 1.0 / rate_hz) {
    const GazeSample closed{.time = nanoseconds_from_seconds(time_s),
                            .direction = towards_deg({40.0, 0.0})};
    EXPECT_EQ(extrapolation.extrapolated(closed), closed.direction);
  }
  const GazeSample next = valid_at(next_s, {pursuit_deg(next_s), 0.0});
  return extrapolation.extrapolated(next) != next.direction;
}

// EyeMovementSettings::longest_interval is 75 ms.
TEST(GazeExtrapolation, BeginsAnewAfterABlinkAndAGap) {
  for (const bool is_blink : {false, true}) {
    EXPECT_TRUE(goes_on_after(3.0 / rate_hz, is_blink)) << "a few lost samples";
    EXPECT_FALSE(goes_on_after(0.076, is_blink));
    EXPECT_FALSE(goes_on_after(0.3, is_blink));
  }
}

TEST(GazeExtrapolation, ARepeatedTimeChangesNothing) {
  GazeExtrapolation once(default_horizon);
  GazeExtrapolation twice(default_horizon);
  for (const GazeSample& sample : samples_of(pursuit_deg, 0.3, 0.1)) {
    const Vec3 direction = once.extrapolated(sample);
    EXPECT_EQ(twice.extrapolated(sample), direction);
    EXPECT_EQ(twice.extrapolated(sample), direction);
  }
}

TEST(GazeExtrapolation, BeginsAnewWhenTimeGoesBack) {
  GazeExtrapolation extrapolation(default_horizon);
  for (const GazeSample& sample : samples_of(pursuit_deg, 0.3)) {
    extrapolation.extrapolated(sample);
  }
  const std::vector<GazeSample> again = samples_of(pursuit_deg, 0.1);
  for (std::size_t i = 0; i < again.size(); ++i) {
    const Vec3 later = extrapolation.extrapolated(again[i]);
    EXPECT_EQ(later != again[i].direction, i >= 5) << i;
  }
}

TEST(GazeExtrapolation, NeedsFiveSamples) {
  GazeExtrapolation of_thirty_hz(default_horizon);
  for (int i = 0; i < 30; ++i) {
    const GazeSample sample = valid_at(i / 30.0, {pursuit_deg(i / 30.0), 0.0});
    EXPECT_EQ(of_thirty_hz.extrapolated(sample), sample.direction);
  }
}

}  // namespace
}  // namespace foveola
