#include "study/person/devices/person_tracker.h"

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "tests/renderer/gaze/test_eye_tracker.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

class PersonTrackerTest : public ::testing::Test {
 protected:
  std::vector<GazeSample> poll(Nanoseconds now) {
    std::vector<GazeSample> arrived;
    tracker_.poll(now, arrived);
    return arrived;
  }
  void send(Nanoseconds time, bool valid = true) {
    source_.next.push_back({.time = time, .valid = valid});
  }

  foveola::test::TestEyeTracker source_;
  PersonTracker tracker_{source_};
};

TEST_F(PersonTrackerTest, IsLostAfterASecondOfSilence) {
  send(0s);
  poll(1ms);
  EXPECT_FALSE(tracker_.is_lost());
  poll(1001ms);
  EXPECT_FALSE(tracker_.is_lost());
  poll(1002ms);
  EXPECT_TRUE(tracker_.is_lost());
  send(1200ms);
  poll(1201ms);
  EXPECT_FALSE(tracker_.is_lost());
}

TEST_F(PersonTrackerTest, HasAGazeForAsLongAsABlinkMayTake) {
  EXPECT_FALSE(tracker_.has_gaze(0s));
  send(0s, false);
  poll(1ms);
  EXPECT_FALSE(tracker_.has_gaze(1ms)) << "what comes is not valid";
  send(10ms);
  poll(20ms);
  EXPECT_TRUE(tracker_.has_gaze(20ms));
  send(100ms, false);
  poll(510ms);
  EXPECT_TRUE(tracker_.has_gaze(510ms));
  EXPECT_FALSE(tracker_.has_gaze(511ms));
}

TEST_F(PersonTrackerTest, RepeatsTheNewestValidSampleOnceAndFirst) {
  send(1ms);
  send(2ms);
  send(3ms, false);
  poll(4ms);
  send(5ms);
  tracker_.repeat_newest();
  const std::vector<GazeSample> arrived = poll(6ms);
  ASSERT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived[0].time, 2ms);
  EXPECT_TRUE(arrived[0].valid);
  EXPECT_EQ(arrived[1].time, 5ms);
  EXPECT_TRUE(poll(7ms).empty());
}

TEST_F(PersonTrackerTest, WhatIsRepeatedIsNoNewSample) {
  send(0s);
  poll(1ms);
  poll(900ms);
  tracker_.repeat_newest();
  poll(1500ms);
  EXPECT_TRUE(tracker_.is_lost());
  EXPECT_FALSE(tracker_.has_gaze(1500ms));
}

TEST_F(PersonTrackerTest, ABlinkIsNoLoss) {
  for (int i = 0; i < 20; ++i) {
    send(i * 100ms, false);
    poll(i * 100ms);
    EXPECT_FALSE(tracker_.is_lost());
  }
}

TEST_F(PersonTrackerTest, IsLostAtOnceWhenItSaysWhy) {
  send(0s);
  poll(1ms);
  source_.says = "unplugged";
  poll(2ms);
  EXPECT_TRUE(tracker_.is_lost());
}

TEST_F(PersonTrackerTest, CorrectsByWhatItWasGiven) {
  const GazeCorrection two_degrees_right{.azimuth = {2.0, 1.0, 0.0}};
  tracker_.correct(two_degrees_right);
  send(0s);
  send(1ms, false);
  const std::vector<GazeSample> arrived = poll(2ms);
  ASSERT_EQ(arrived.size(), 2U);
  EXPECT_NEAR(degrees(azimuth_elevation(arrived[0].direction).azimuth_rad), 2.0, 1e-4);
  EXPECT_EQ(arrived[1].direction, Vec3(0.0F, 0.0F, -1.0F));
  tracker_.correct(std::nullopt);
  send(3ms);
  EXPECT_EQ(poll(4ms)[0].direction, Vec3(0.0F, 0.0F, -1.0F));
}

}  // namespace
}  // namespace foveola::study
