#include "renderer/gaze/gaze_marker.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/gaze/simulated_eye.h"
#include "tests/renderer/gaze/gaze_expectations.h"

namespace foveola {
namespace {

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
