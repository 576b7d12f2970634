#include "renderer/gaze/pointer_eye_tracker.h"

#include <thread>

#include <gtest/gtest.h>

#include "tests/renderer/gaze/newest_gaze.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using test::NewestGaze;
using test::polled;

const Vec3 to_the_right(1.0F, 0.0F, 0.0F);
const Vec3 upwards(0.0F, 1.0F, 0.0F);

TEST(PointerEyeTracker, RestsWhereItWasMovedToLast) {
  PointerEyeTracker pointer;
  NewestGaze newest(pointer);
  EXPECT_FALSE(newest(milliseconds(0)));
  pointer.point_at(milliseconds(1), to_the_right);
  pointer.point_at(milliseconds(2), upwards);
  for (const Nanoseconds now : {milliseconds(5), milliseconds(7005)}) {
    const auto sample = newest(now);
    ASSERT_TRUE(sample && sample->valid);
    EXPECT_EQ(sample->time, now);
    EXPECT_EQ(sample->direction, upwards);
  }
}

TEST(PointerEyeTracker, IsNotThereBeforeItsEvent) {
  PointerEyeTracker pointer;
  NewestGaze newest(pointer);
  pointer.point_at(milliseconds(6), to_the_right);
  EXPECT_EQ(newest(milliseconds(5))->time, milliseconds(6));
}

TEST(PointerEyeTracker, OutsideTheWindowItSeesNothing) {
  PointerEyeTracker pointer;
  NewestGaze newest(pointer);
  pointer.point_at(milliseconds(1), to_the_right);
  pointer.point_at(milliseconds(2), std::nullopt);
  ASSERT_TRUE(newest(milliseconds(5)));
  EXPECT_FALSE(newest(milliseconds(5))->valid);
  pointer.point_at(milliseconds(6), upwards);
  EXPECT_TRUE(newest(milliseconds(7))->valid);
}

TEST(PointerEyeTracker, IsSampledEvenlyHoweverSeldomItIsAsked) {
  PointerEyeTracker pointer;
  pointer.point_at(milliseconds(1), to_the_right);
  EXPECT_EQ(polled(pointer, milliseconds(5)).size(), 1U);
  EXPECT_EQ(polled(pointer, milliseconds(10)).size(), 1U) << "less than an interval later";
  const std::vector<GazeSample> samples = polled(pointer, milliseconds(110));
  ASSERT_EQ(samples.size(), 13U);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_NEAR(foveola::seconds(samples[i].time), 0.010 + 0.1 / 13.0 * static_cast<double>(i + 1),
                1e-6);
    EXPECT_TRUE(samples[i].valid);
    EXPECT_EQ(samples[i].direction, to_the_right);
  }
  EXPECT_EQ(samples.back().time, milliseconds(110));
}

TEST(PointerEyeTracker, SamplesAreWhereItWasAtTheirTimes) {
  PointerEyeTracker pointer;
  pointer.point_at(milliseconds(0), to_the_right);
  (void)polled(pointer, milliseconds(0));
  pointer.point_at(milliseconds(20), upwards);
  pointer.point_at(milliseconds(28), std::nullopt);
  const std::vector<GazeSample> samples = polled(pointer, milliseconds(40));
  ASSERT_EQ(samples.size(), 5U);
  EXPECT_EQ(samples[1].direction, to_the_right) << "at 16 ms";
  EXPECT_EQ(samples[2].direction, upwards) << "at 24 ms";
  EXPECT_FALSE(samples[3].valid) << "at 32 ms";
  EXPECT_TRUE(samples[2].valid);
}

TEST(PointerEyeTracker, WhatWasLongAgoIsNotSampled) {
  PointerEyeTracker pointer;
  pointer.point_at(milliseconds(0), to_the_right);
  (void)polled(pointer, milliseconds(0));
  for (int i = 1; i <= 1000; ++i) {
    pointer.point_at(milliseconds(100 * i), i % 2 == 0 ? to_the_right : upwards);
  }
  EXPECT_EQ(polled(pointer, milliseconds(3'600'000)).size(), 1U);
}

// For the thread sanitizer, and that no sample is half of one event and half of another.
TEST(PointerEyeTracker, MovesWhileFramesLook) {
  PointerEyeTracker pointer;
  NewestGaze newest(pointer);
  pointer.point_at(Nanoseconds(0), to_the_right);
  std::thread moving([&] {
    for (int i = 1; i < 2000; ++i) {
      pointer.point_at(Nanoseconds(i), i % 2 == 0 ? to_the_right : upwards);
    }
  });
  for (int i = 0; i < 2000; ++i) {
    const auto sample = newest(Nanoseconds(i));
    ASSERT_TRUE(sample && sample->valid);
    ASSERT_TRUE(sample->direction == to_the_right || sample->direction == upwards);
  }
  moving.join();
  EXPECT_EQ(newest(milliseconds(1))->direction, upwards);
}

}  // namespace
}  // namespace foveola
