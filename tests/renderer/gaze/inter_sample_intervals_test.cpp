#include "renderer/gaze/inter_sample_intervals.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

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
