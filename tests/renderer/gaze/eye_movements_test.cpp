#include "renderer/gaze/eye_movements.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/gaze/simulated_eye.h"
#include "tests/renderer/gaze/gaze_expectations.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using test::lost_at;
using test::seen_at;

using enum EyeMovementKind;

double amplitude_deg(const EyeMovement& movement) {
  return degrees(angle_between(movement.from, movement.to));
}

std::vector<EyeMovement> movements_in(const std::vector<GazeSample>& samples,
                                      const EyeMovementSettings& settings = {}) {
  EyeMovementDetector detector(settings);
  std::vector<EyeMovement> movements;
  for (const GazeSample& sample : samples) {
    for (const EyeMovement& movement : detector.push(sample)) {
      movements.push_back(movement);
    }
  }
  if (const auto last = detector.finish()) {
    movements.push_back(*last);
  }
  return movements;
}

/// "F 0-100 S 100-120": kinds and times in milliseconds.
std::string text_of(const std::vector<EyeMovement>& movements) {
  std::string text;
  for (const EyeMovement& m : movements) {
    text += text.empty() ? "" : " ";
    text += m.kind == fixation ? "F " : m.kind == saccade ? "S " : "- ";
    text +=
        std::to_string(m.start / milliseconds(1)) + "-" + std::to_string(m.end / milliseconds(1));
  }
  return text;
}

/// Every 10 ms, the azimuth by which it moves in each step.
std::vector<GazeSample> moving_by(const std::vector<double>& steps_deg) {
  std::vector<GazeSample> samples{seen_at(0, 0.0)};
  double azimuth_deg = 0.0;
  for (const double step_deg : steps_deg) {
    azimuth_deg += step_deg;
    samples.push_back(seen_at(10 * static_cast<int>(samples.size()), azimuth_deg));
  }
  return samples;
}

std::vector<double> steps(std::initializer_list<std::pair<int, double>> runs) {
  std::vector<double> all;
  for (const auto& [count, step_deg] : runs) {
    all.insert(all.end(), static_cast<std::size_t>(count), step_deg);
  }
  return all;
}

TEST(EyeMovements, AStepFasterThanTheThresholdIsASaccade) {
  const auto movements = movements_in(moving_by(steps({{10, 0.5}, {3, 2.0}, {10, 0.1}})));
  EXPECT_EQ(text_of(movements), "F 0-100 S 100-130 F 130-230");
  EXPECT_NEAR(amplitude_deg(movements[1]), 6.0, 1e-4);
  EXPECT_NEAR(movements[1].fastest_deg_per_s, 200.0, 1e-2);
  EXPECT_NEAR(movements[0].fastest_deg_per_s, 50.0, 1e-2);
  EXPECT_NEAR(amplitude_deg(movements[0]), 5.0, 1e-4);
}

TEST(EyeMovements, TheThresholdIsASetting) {
  const auto samples = moving_by(steps({{10, 0.1}, {3, 0.5}, {10, 0.1}}));
  EXPECT_EQ(text_of(movements_in(samples)), "F 0-230");
  EXPECT_EQ(text_of(movements_in(samples, {.threshold_deg_per_s = 40.0})),
            "F 0-100 S 100-130 F 130-230");
}

// Ten degrees of azimuth at an elevation of 80 degrees are not two degrees of angle.
TEST(EyeMovements, VelocityIsByTheTrueAngle) {
  const auto high_up = [](int time_ms, double azimuth_deg) {
    return GazeSample{.time = milliseconds(time_ms),
                      .direction = direction_from(
                          {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(80.0)}),
                      .valid = true};
  };
  const auto movements = movements_in({high_up(0, 0.0), high_up(10, 10.0)});
  const double angle_deg =
      2.0 * degrees(std::asin(std::cos(radians(80.0)) * std::sin(radians(5.0))));
  EXPECT_NEAR(movements[0].fastest_deg_per_s, 100.0 * angle_deg, 0.01);
}

TEST(EyeMovements, AShortSaccadeBelongsToTheFixationAroundIt) {
  const auto samples = moving_by(steps({{10, 0.1}, {1, 2.0}, {10, 0.1}}));
  EXPECT_EQ(text_of(movements_in(samples, {.shortest_saccade = milliseconds(11)})), "F 0-210");
  EXPECT_EQ(text_of(movements_in(samples, {.shortest_saccade = milliseconds(10)})),
            "F 0-100 S 100-110 F 110-210");
}

TEST(EyeMovements, AShortFixationBelongsToTheSaccadeAroundIt) {
  const auto samples = moving_by(steps({{10, 0.1}, {3, 2.0}, {5, 0.1}, {3, 2.0}, {10, 0.1}}));
  EXPECT_EQ(text_of(movements_in(samples)), "F 0-100 S 100-210 F 210-310");
  EXPECT_EQ(text_of(movements_in(samples, {.shortest_fixation = milliseconds(50)})),
            "F 0-100 S 100-130 F 130-180 S 180-210 F 210-310");
}

TEST(EyeMovements, WhatIsTooShortAtTheEndBelongsToWhatWasBefore) {
  EXPECT_EQ(text_of(movements_in(moving_by(steps({{10, 0.1}, {3, 2.0}, {3, 0.1}})))),
            "F 0-100 S 100-160");
}

TEST(EyeMovements, ALongBlinkIsNoData) {
  EXPECT_EQ(text_of(movements_in({seen_at(0, 0.0), seen_at(10, 0.1), lost_at(20), lost_at(60),
                                  lost_at(100), seen_at(200, 5.0), seen_at(210, 5.1),
                                  seen_at(220, 5.1)})),
            "F 0-10 - 10-200 F 200-220");
}

TEST(EyeMovements, AGapInTheSamplesIsNoData) {
  EXPECT_EQ(text_of(movements_in(
                {seen_at(0, 0.0), seen_at(10, 0.1), seen_at(100, 0.1), seen_at(110, 0.1)})),
            "F 0-10 - 10-100 F 100-110");
}

TEST(EyeMovements, AFewLostSamplesAreBridged) {
  EXPECT_EQ(text_of(movements_in({seen_at(0, 0.0), seen_at(10, 0.1), lost_at(20), lost_at(30),
                                  seen_at(40, 0.2), seen_at(50, 0.3)})),
            "F 0-50");
  EXPECT_EQ(text_of(movements_in({seen_at(0, 0.0), seen_at(10, 0.0), lost_at(20), seen_at(30, 3.0),
                                  seen_at(40, 3.0)})),
            "F 0-10 S 10-40");
}

TEST(EyeMovements, AStreamMayBeginAndEndWithoutData) {
  EXPECT_EQ(text_of(movements_in({lost_at(0), lost_at(10), seen_at(20, 0.0), seen_at(30, 0.0),
                                  lost_at(50), lost_at(150), lost_at(300)})),
            "- 0-20 F 20-30 - 30-300");
  EXPECT_EQ(text_of(movements_in({lost_at(0), lost_at(500)})), "- 0-500");
  EXPECT_EQ(text_of(movements_in({seen_at(0, 0.0), seen_at(500, 0.0)})), "- 0-500");
  EXPECT_TRUE(movements_in({}).empty());
  EXPECT_TRUE(movements_in({seen_at(0, 0.0)}).empty());
}

TEST(EyeMovements, RepeatedAndEarlierSamplesArePassedOver) {
  EXPECT_EQ(text_of(movements_in({seen_at(0, 0.0), seen_at(10, 0.1), seen_at(10, 9.0),
                                  seen_at(5, 40.0), seen_at(20, 0.2)})),
            "F 0-20");
}

TEST(EyeMovements, ReportsAtOnceWhatTheNewestSamplesSay) {
  EyeMovementDetector detector({});
  EXPECT_EQ(detector.now(), no_data);
  detector.push(seen_at(0, 0.0));
  EXPECT_EQ(detector.now(), no_data);  // one sample has no velocity
  detector.push(seen_at(10, 0.1));
  EXPECT_EQ(detector.now(), fixation);
  detector.push(seen_at(20, 3.0));
  EXPECT_EQ(detector.now(), saccade);
  detector.push(seen_at(20, 3.0));
  EXPECT_EQ(detector.now(), saccade);
  detector.push(lost_at(30));
  EXPECT_EQ(detector.now(), no_data);
  detector.push(seen_at(40, 3.1));
  EXPECT_EQ(detector.now(), fixation);
}

TEST(EyeMovements, FinishingMakesADetectorAsNew) {
  EyeMovementDetector detector({});
  detector.push(seen_at(1000, 0.0));
  detector.push(seen_at(1010, 0.0));
  EXPECT_TRUE(detector.finish());
  EXPECT_FALSE(detector.finish());
  detector.push(seen_at(0, 0.0));
  detector.push(seen_at(10, 0.0));
  EXPECT_EQ(text_of({*detector.finish()}), "F 0-10");
}

/// What a tracker of this rate sees of the eye.
std::vector<GazeSample> samples_of(SimulatedEye& eye, const SimulatedTrackerSettings& settings,
                                   Nanoseconds end) {
  SimulatedEyeTracker tracker(settings, [&](Nanoseconds time) { return eye.gaze(time); });
  std::vector<GazeSample> samples;
  for (Nanoseconds now{0}; now < end; now += nanoseconds_from_seconds(0.5 / settings.rate_hz)) {
    tracker.poll(now, samples);
  }
  return samples;
}

std::vector<EyeMovement> only(EyeMovementKind kind, std::vector<EyeMovement> movements) {
  std::erase_if(movements, [&](const EyeMovement& m) { return m.kind != kind; });
  return movements;
}

bool overlap(const EyeMovement& found, const SimulatedSaccade& truth) {
  return found.start < truth.end && truth.start < found.end;
}

// By the formula of its progress, a saccade of 1 to 30 degrees exceeds 30 degrees per second from
// up to 7 ms after its beginning until as long before its end, and goes 30 c / (2 eta) = 0.15
// degrees before and after that. What an interval at each end holds comes on top.
TEST(EyeMovements, FindsEverySaccadeOfAQuietEyeWhereItIs) {
  for (const double rate_hz : {120.0, 1000.0}) {
    SimulatedEye eye({.seed = 21, .microsaccade_interval_s = 0.0, .blinks_per_minute = 0.0});
    const auto found = only(
        saccade,
        movements_in(samples_of(eye, {.rate_hz = rate_hz, .latency_s = 0.0, .precision_deg = 0.0},
                                minutes(5)),
                     {.threshold_deg_per_s = 30.0}));
    std::vector<SimulatedSaccade> truth = eye.saccades(minutes(5) - milliseconds(200));
    ASSERT_GT(truth.size(), 800U);
    ASSERT_GE(found.size(), truth.size());
    const double tolerance_s = 0.007 + 1.0 / rate_hz;
    const double missed_deg = 0.3 + 2.0 * 30.0 / rate_hz;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ASSERT_TRUE(overlap(found[i], truth[i])) << i;
      ASSERT_NEAR(foveola::seconds(found[i].start - truth[i].start), 0.0, tolerance_s) << i;
      ASSERT_NEAR(foveola::seconds(found[i].end - truth[i].end), 0.0, tolerance_s) << i;
      ASSERT_GT(amplitude_deg(found[i]), truth[i].amplitude_deg - missed_deg) << i;
      ASSERT_LT(amplitude_deg(found[i]), truth[i].amplitude_deg + 1e-4) << i;
    }
  }
}

// All that a simulated tracker has: noise, microsaccades, blinks and lost samples.
TEST(EyeMovements, FindsTheLargeSaccadesOfARestlessEyeAndInventsNone) {
  SimulatedEye eye({.seed = 22});
  const auto movements =
      movements_in(samples_of(eye, {.latency_s = 0.0, .data_loss = 0.02, .seed = 3}, minutes(20)));
  const auto found = only(saccade, movements);
  const std::vector<SimulatedSaccade> truth = eye.saccades(minutes(20));
  const std::vector<SimulatedBlink> blinks = eye.blinks(minutes(20));

  const auto is_seen = [&](const SimulatedSaccade& s) {
    return std::none_of(blinks.begin(), blinks.end(), [&](const SimulatedBlink& b) {
      return b.start < s.end + milliseconds(50) && s.start < b.end + milliseconds(50);
    });
  };
  int large = 0;
  int found_large = 0;
  for (const SimulatedSaccade& s : truth) {
    if (s.amplitude_deg >= 4.0 && is_seen(s)) {
      ++large;
      found_large += std::any_of(found.begin(), found.end(),
                                 [&](const EyeMovement& m) { return overlap(m, s); });
    }
  }
  const auto invented = std::count_if(found.begin(), found.end(), [&](const EyeMovement& m) {
    return std::none_of(truth.begin(), truth.end(),
                        [&](const SimulatedSaccade& s) { return !s.is_micro && overlap(m, s); });
  });
  ASSERT_GT(large, 2000);
  EXPECT_GT(found_large, 0.99 * large);
  EXPECT_LE(invented, 0.002 * static_cast<double>(found.size()));

  // A blink of 100 ms and more leaves at least as much time without data.
  EXPECT_EQ(only(no_data, movements).size(), blinks.size());
}

using std::chrono::milliseconds;
using test::lost_at;
using test::seen_at;

std::vector<GazeSample> marked(const std::vector<GazeSample>& samples) {
  GazeMarker marker;
  std::vector<GazeSample> out;
  for (const GazeSample& sample : samples) {
    marker.push(sample, out);
  }
  marker.finish(out);
  return out;
}

/// A letter a sample: f, s, b, or a hyphen for none.
std::string marks_of(const std::vector<GazeSample>& samples) {
  std::string marks;
  for (const GazeSample& sample : marked(samples)) {
    marks.push_back("-fsb"[static_cast<std::size_t>(sample.mark)]);
  }
  return marks;
}

// At 100 Hz, 5 degrees a sample are 500 degrees a second.
TEST(GazeMarker, ASaccadeIsWhatMovesFast) {
  std::vector<GazeSample> samples;
  for (int i = 0; i < 10; ++i) {
    samples.push_back(seen_at(10 * i, 0.0));
  }
  samples.push_back(seen_at(100, 5.0));
  samples.push_back(seen_at(110, 10.0));
  for (int i = 12; i < 22; ++i) {
    samples.push_back(seen_at(10 * i, 10.0));
  }
  EXPECT_EQ(marks_of(samples), "ffffffffffssffffffffff");
}

TEST(GazeMarker, ABlinkLastsUpToSixHundredMilliseconds) {
  const auto with_pause = [](int pause_ms) {
    std::vector<GazeSample> samples;
    for (int i = 0; i < 8; ++i) {
      samples.push_back(seen_at(10 * i, 0.0));
    }
    for (int time_ms = 80; time_ms < 70 + pause_ms; time_ms += 100) {
      samples.push_back(lost_at(time_ms));
    }
    for (int i = 0; i < 8; ++i) {
      samples.push_back(seen_at(70 + pause_ms + 10 * i, 0.0));
    }
    return samples;
  };
  EXPECT_EQ(marks_of(with_pause(50)), "fffffffffffffffff") << "too short for one";
  EXPECT_EQ(marks_of(with_pause(200)), "ffffffffbbffffffff");
  EXPECT_EQ(marks_of(with_pause(600)), "ffffffffbbbbbbffffffff");
  EXPECT_EQ(marks_of(with_pause(700)), "ffffffff-------ffffffff");
}

TEST(GazeMarker, ATrackerThatSendsNothingLeavesNothingToMark) {
  EXPECT_EQ(marks_of({seen_at(0, 0.0), seen_at(10, 0.0), seen_at(300, 1.0), seen_at(310, 1.0)}),
            "ffff");
  EXPECT_EQ(marks_of({seen_at(0, 0.0)}), "-");
  EXPECT_EQ(marks_of({}), "");
}

// What a tracker sees of an eye whose every movement is known. What follows a saccade for less than
// a fixation, before a blink, counts as the saccade's.
TEST(GazeMarker, AgreesWithTheEyeThatMoved) {
  SimulatedEye eye({.seed = 3, .microsaccade_interval_s = 0.0});
  constexpr Nanoseconds end = std::chrono::seconds(60);
  SimulatedEyeTracker tracker({.rate_hz = 500.0, .latency_s = 0.0, .precision_deg = 0.0},
                              [&](Nanoseconds time) { return eye.gaze(time); });
  std::vector<GazeSample> samples;
  for (Nanoseconds now{0}; now < end; now += milliseconds(10)) {
    tracker.poll(now, samples);
  }
  const std::vector<SimulatedSaccade> saccades = eye.saccades(end);
  const auto is_in_saccade = [&](const GazeSample& sample) {
    return std::any_of(saccades.begin(), saccades.end(), [&](const SimulatedSaccade& s) {
      return s.start <= sample.time &&
             sample.time <= s.end + EyeMovementSettings{}.shortest_fixation;
    });
  };
  const std::vector<GazeSample> out = marked(samples);
  ASSERT_EQ(out.size(), samples.size());
  int blinks = 0;
  int in_saccades = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    ASSERT_EQ(out[i].time, samples[i].time);
    ASSERT_EQ(out[i].direction, samples[i].direction);
    ASSERT_EQ(out[i].valid, samples[i].valid);
    blinks += out[i].mark == GazeMark::blink ? 1 : 0;
    in_saccades += out[i].mark == GazeMark::saccade ? 1 : 0;
    ASSERT_TRUE(out[i].mark != GazeMark::blink || !out[i].valid) << i;
    ASSERT_TRUE(out[i].mark != GazeMark::saccade || is_in_saccade(out[i])) << i;
    ASSERT_TRUE(out[i].valid || out[i].mark == GazeMark::blink) << i;
  }
  EXPECT_GT(blinks, 500);
  EXPECT_GT(in_saccades, 500);
}

TEST(MarkedMovements, LastUntilTheNextOne) {
  std::vector<GazeSample> samples = {seen_at(0, 0.0), seen_at(10, 0.0), lost_at(25),
                                     seen_at(40, 0.0), seen_at(50, 0.0)};
  samples[0].mark = samples[1].mark = GazeMark::fixation;
  samples[2].mark = GazeMark::blink;
  samples[3].mark = samples[4].mark = GazeMark::fixation;
  const std::vector<MarkedMovement> movements = marked_movements(samples);
  ASSERT_EQ(movements.size(), 3U);
  EXPECT_EQ(movements[0].mark, GazeMark::fixation);
  EXPECT_EQ(movements[0].samples.size(), 2U);
  EXPECT_EQ(movements[0].duration, milliseconds(25));
  EXPECT_EQ(movements[1].mark, GazeMark::blink);
  EXPECT_EQ(movements[1].duration, milliseconds(15));
  EXPECT_EQ(movements[2].samples.front().time, milliseconds(40));
  EXPECT_EQ(movements[2].duration, milliseconds(10));
  EXPECT_TRUE(marked_movements({}).empty());
}

}  // namespace

}  // namespace foveola
