#include "study/console/live_figures.h"

#include <array>

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

GazeSample sample_at(Nanoseconds time, bool valid) { return {.time = time, .valid = valid}; }

TEST(LiveFigures, ARateIsOfAWholeSecond) {
  LiveFigures figures;
  for (int frame = 0; frame < 50; ++frame) {
    figures.add_frame(5s + frame * 20ms, {});
  }
  EXPECT_FALSE(figures.frames(50.0).rate_hz);
  figures.add_frame(6s, {});
  EXPECT_DOUBLE_EQ(figures.frames(50.0).rate_hz.value(), 50.0);
  for (int frame = 1; frame <= 10; ++frame) {
    figures.add_frame(6s + frame * 100ms, {});
  }
  EXPECT_DOUBLE_EQ(figures.frames(50.0).rate_hz.value(), 10.0);
}

TEST(LiveFigures, FramesOfAnAttemptAreCountedByThemselves) {
  LiveFigures figures;
  figures.add_attempt_frame(true);
  figures.begin_attempt();
  for (int frame = 0; frame < 10; ++frame) {
    figures.add_attempt_frame(frame == 3);
  }
  EXPECT_EQ(figures.frames(60.0).frames, 10U);
  EXPECT_EQ(figures.frames(60.0).late, 1U);
}

TEST(LiveFigures, GazeIsOfTheLastSecondAndItsAgeOfTheNewestValidSample) {
  LiveFigures figures;
  EXPECT_FALSE(figures.gaze("tracked", 0s).age_s);
  figures.add_frame(0s, std::array{sample_at(-10ms, true)});
  figures.add_frame(500ms, std::array{sample_at(480ms, true), sample_at(490ms, false)});
  figures.add_frame(1s, std::array{sample_at(990ms, false)});
  const GazeStatus gaze = figures.gaze("tracked", 1200ms);
  EXPECT_DOUBLE_EQ(gaze.valid.value(), 0.5);
  EXPECT_NEAR(gaze.age_s.value(), 0.72, 1e-9);
  figures.add_frame(2s, {});
  EXPECT_FALSE(figures.gaze("tracked", 2s).valid) << "none came";
}

TEST(LiveFigures, ASampleFromTheFutureIsNotOldYet) {
  LiveFigures figures;
  figures.add_frame(0s, std::array{sample_at(30ms, true)});
  EXPECT_EQ(figures.gaze("tracked", 0s).age_s, 0.0);
}

}  // namespace
}  // namespace foveola::study
