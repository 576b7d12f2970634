#include "renderer/preview/frame_latency.h"

#include <array>

#include <gtest/gtest.h>

namespace foveola {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

/// FOVE 0, by the published account.
TrackerProfile published_tracker() {
  TrackerProfile tracker;
  tracker.rate_hz = 120.0;
  tracker.exposure = {.duration_s = 0.008};
  tracker.transfer = {.duration_s = 0.002, .provenance = Provenance::measured};
  tracker.processing = {.duration_s = 0.004};
  return tracker;
}

DisplayProfile published_display() {
  DisplayProfile display;
  display.scan_out = {.duration_s = 0.014};
  return display;
}

/// A frame of 14 ms whose gaze arrived as it looked: 4 ms of exposure, 2 and 4 ms.
LiveFrame published_frame() {
  LiveFrame frame{.start = milliseconds(5000), .deadline = milliseconds(5014)};
  frame.report.gaze_valid = true;
  frame.report.gaze_age = milliseconds(10);
  frame.polling = microseconds(20);
  frame.tracing = microseconds(9980);
  frame.resampling = milliseconds(3);
  frame.presenting = microseconds(500);
  frame.shown = frame.deadline;
  frame.is_refresh_measured = true;
  return frame;
}

LatencyStages stages_of(const LiveFrame& frame) {
  return frame_latency(frame, published_tracker(), published_display());
}

// Koskela et al. 2018, figure 7: 4 + 2 + 4 + 14 + 14 ms.
TEST(FrameLatency, OfThePublishedFrame) {
  EXPECT_NEAR(total_latency(stages_of(published_frame())).best_s, 0.038, 1e-12);
}

TEST(FrameLatency, IsMadeOfWhatTheFrameTook) {
  LiveFrame frame = published_frame();
  frame.report.gaze_age = milliseconds(13);
  const double best_ms[] = {4.0, 2.0, 4.0, 3.0, 10.0, 3.0, 1.0, 14.0};
  const LatencyStages stages = stages_of(frame);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    EXPECT_NEAR(1e3 * stages[i].best_s, best_ms[i], 1e-9) << stages[i].name;
    const double range_ms = i == 0 ? 1e3 / 120.0 : 0.0;  // the eye may have moved a period before
    EXPECT_NEAR(1e3 * (stages[i].worst_s - stages[i].best_s), range_ms, 1e-9) << stages[i].name;
  }
}

TEST(FrameLatency, ALateFrameWaitsToBePresented) {
  LiveFrame frame = published_frame();
  frame.tracing = milliseconds(12);
  frame.shown = milliseconds(5028);
  EXPECT_NEAR(total_latency(stages_of(frame)).best_s, 0.052, 1e-12) << "a refresh more";
}

TEST(FrameLatency, SaysWhatIsMeasured) {
  const auto is_measured = [](const LiveFrame& frame) {
    std::array<bool, 8> measured{};
    for (std::size_t i = 0; i < measured.size(); ++i) {
      measured[i] = stages_of(frame)[i].provenance == Provenance::measured;
    }
    return measured;
  };
  LiveFrame frame = published_frame();
  EXPECT_EQ(is_measured(frame), (std::array{false, true, false, true, true, true, true, false}));
  frame.is_refresh_measured = false;
  EXPECT_EQ(is_measured(frame), (std::array{false, true, false, true, true, true, false, false}));
}

TEST(FrameLatency, AGazeYoungerThanItsTrackerAllowsHasNotWaited) {
  LiveFrame frame = published_frame();
  frame.report.gaze_age = milliseconds(6);
  EXPECT_EQ(stages_of(frame)[3].best_s, 0.0);
}

TEST(FrameLatency, HeldGazeDoesNotFollowTheEye) {
  EXPECT_TRUE(follows_eye({.gaze_valid = true}));
  EXPECT_FALSE(follows_eye({.gaze_valid = false}));
  EXPECT_FALSE(follows_eye({.gaze_valid = true, .gaze_held = true}));
}

// 8.33 + 4 + 2 + 4 ms.
TEST(FrameLatency, GazeIsAPeriodOldAtMostAndWhatItsTrackerTakes) {
  EXPECT_NEAR(gaze_age_limit_s(published_tracker()), 0.018333333, 1e-8);
}

}  // namespace
}  // namespace foveola
