#include <gtest/gtest.h>

#include "renderer/gaze/device_clocks.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// The host's time of what was stamped stamped_ms and arrived at arrival_ms.
Nanoseconds aligned(ClockAlignment& alignment, int stamped_ms, int arrival_ms) {
  return alignment.host_time(milliseconds(stamped_ms), milliseconds(arrival_ms));
}

TEST(ClockAlignment, TheFirstIsTakenForUndelayed) {
  ClockAlignment alignment(seconds(10));
  EXPECT_EQ(aligned(alignment, 50, 1000), milliseconds(1000));
}

TEST(ClockAlignment, WhatComesLateWasStampedEarlier) {
  ClockAlignment alignment(seconds(10));
  aligned(alignment, 0, 1000);
  EXPECT_EQ(aligned(alignment, 10, 1017), milliseconds(1010));
  EXPECT_EQ(aligned(alignment, 20, 1020), milliseconds(1020));
}

TEST(ClockAlignment, AFasterDeliveryTakesOver) {
  ClockAlignment alignment(seconds(10));
  aligned(alignment, 0, 1008);  // eight too late, as turns out
  EXPECT_EQ(aligned(alignment, 10, 1010), milliseconds(1010));
  EXPECT_EQ(aligned(alignment, 20, 1028), milliseconds(1020));
}

TEST(ClockAlignment, ForgetsWhatLeftTheWindow) {
  ClockAlignment alignment(milliseconds(100));
  aligned(alignment, 0, 1000);
  EXPECT_EQ(aligned(alignment, 95, 1100), milliseconds(1095));  // the first still counts
  EXPECT_EQ(aligned(alignment, 96, 1101), milliseconds(1101));  // and now does not
}

// A clock that runs a tenth of a millisecond per second slow: offsets grow, and are followed.
TEST(ClockAlignment, FollowsADriftingClock) {
  ClockAlignment alignment(seconds(10));
  const Nanoseconds lag_per_second = std::chrono::microseconds(100);
  for (int i = 0; i < 600; ++i) {
    const Nanoseconds arrival = seconds(i);
    const Nanoseconds error = arrival - alignment.host_time(arrival - i * lag_per_second, arrival);
    ASSERT_GE(error, Nanoseconds::zero());
    ASSERT_LE(error, 10 * lag_per_second);
  }
}

TEST(ClockAlignment, BeginsAnewWhenTheTrackersClockIsSetBack) {
  ClockAlignment alignment(seconds(10));
  aligned(alignment, 5000, 6000);
  EXPECT_EQ(aligned(alignment, 0, 6010), milliseconds(6010));
  EXPECT_EQ(aligned(alignment, 10, 6025), milliseconds(6020));
}

}  // namespace
}  // namespace foveola
