#include "renderer/gaze/sample_rhythm.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

using std::chrono::milliseconds;

GazeSample sample_at(int time_ms, bool valid = true) {
  return {.time = milliseconds(time_ms), .valid = valid};
}

TEST(SampleRhythm, KnowsNothingOfOneSample) {
  SampleRhythm rhythm;
  rhythm.add(sample_at(5));
  EXPECT_EQ(rhythm.samples(), 1U);
  EXPECT_FALSE(rhythm.rate_hz());
  EXPECT_FALSE(rhythm.jitter_ms());
}

TEST(SampleRhythm, CountsEverySampleOnce) {
  SampleRhythm rhythm;
  for (const int time_ms : {0, 10, 10, 10, 20, 15, 30}) {
    rhythm.add(sample_at(time_ms, time_ms != 20));
  }
  EXPECT_EQ(rhythm.samples(), 4U);
  EXPECT_EQ(rhythm.valid_samples(), 3U);
  EXPECT_EQ(rhythm.gaps(), 0U);
  EXPECT_DOUBLE_EQ(*rhythm.rate_hz(), 100.0);
  EXPECT_NEAR(*rhythm.jitter_ms(), 0.0, 1e-9);
}

TEST(SampleRhythm, TellsGapsAndJitter) {
  SampleRhythm rhythm;
  for (const int time_ms : {0, 10, 19, 30, 40, 70, 80}) {
    rhythm.add(sample_at(time_ms));
  }
  EXPECT_EQ(rhythm.gaps(), 1U);
  EXPECT_DOUBLE_EQ(*rhythm.rate_hz(), 100.0);
  EXPECT_NEAR(*rhythm.jitter_ms(), (0 + 1 + 1 + 0 + 20 + 0) / 6.0, 1e-9);
}

TEST(SampleRhythm, ForgetsAnOldRate) {
  SampleRhythm rhythm;
  int time_ms = 0;
  for (int i = 0; i < 300; ++i) {
    rhythm.add(sample_at(time_ms += 10));
  }
  for (std::size_t i = 0; i < SampleRhythm::window; ++i) {
    rhythm.add(sample_at(time_ms += 5));
  }
  EXPECT_DOUBLE_EQ(*rhythm.rate_hz(), 200.0);
}

}  // namespace
}  // namespace foveola
