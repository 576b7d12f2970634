#include <gtest/gtest.h>

#include "renderer/headset/headset_motion.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

const Vec3 left(-0.6F, 0.0F, -0.8F);
const Vec3 right(0.6F, 0.0F, -0.8F);

TEST(GazeTimes, AreThoseThatTheRuntimeTells) {
  GazeTimes times;
  const auto sample = times.sample_of({.asked = milliseconds(100),
                                       .sampled = milliseconds(92),
                                       .direction = left,
                                       .is_valid = true});
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->time, milliseconds(92));
  EXPECT_EQ(sample->direction, left);
  EXPECT_TRUE(sample->valid && sample->is_time_known);
}

TEST(GazeTimes, TellOfASampleOnce) {
  GazeTimes times;
  ToldGaze told{
      .asked = milliseconds(100), .sampled = milliseconds(92), .direction = left, .is_valid = true};
  EXPECT_TRUE(times.sample_of(told));
  told.asked = milliseconds(105);
  EXPECT_FALSE(times.sample_of(told));
  told.sampled = milliseconds(101);
  EXPECT_TRUE(times.sample_of(told));
}

TEST(GazeTimes, AreThoseOfAskingWhereTheRuntimeKnowsNone) {
  GazeTimes times;
  for (const int ms : {100, 111}) {
    const auto sample =
        times.sample_of({.asked = milliseconds(ms), .direction = left, .is_valid = true});
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->time, milliseconds(ms));
    EXPECT_FALSE(sample->is_time_known);
  }
}

TEST(GazeTimes, AreNotBelievedWhereTheyCannotBe) {
  const auto second_of = [](Nanoseconds sampled) {
    GazeTimes times;
    times.sample_of({.asked = milliseconds(2000),
                     .sampled = milliseconds(1990),
                     .direction = left,
                     .is_valid = true});
    return *times.sample_of(
        {.asked = milliseconds(2011), .sampled = sampled, .direction = right, .is_valid = true});
  };
  EXPECT_TRUE(second_of(milliseconds(2001)).is_time_known);
  for (const int ms : {3011, 1990, 1980, 500}) {  // to come, stuck, backwards, long ago
    const GazeSample sample = second_of(milliseconds(ms));
    EXPECT_FALSE(sample.is_time_known) << ms;
    EXPECT_EQ(sample.time, milliseconds(2011)) << ms;
    EXPECT_EQ(sample.direction, right);
  }
}

TEST(GazeTimes, AreBelievedForASecond) {
  for (const auto& [ms, is_known] : {std::pair(1011, true), std::pair(1010, false)}) {
    GazeTimes times;
    const auto first = times.sample_of({.asked = milliseconds(2011),
                                        .sampled = milliseconds(ms),
                                        .direction = left,
                                        .is_valid = true});
    EXPECT_EQ(first->is_time_known, is_known) << ms;
  }
}

TEST(GazeTimes, TellOfABlink) {
  GazeTimes times;
  times.sample_of({.asked = milliseconds(100),
                   .sampled = milliseconds(92),
                   .direction = left,
                   .is_valid = true});
  const auto blink = times.sample_of(
      {.asked = milliseconds(111), .sampled = milliseconds(103), .direction = left});
  ASSERT_TRUE(blink);
  EXPECT_FALSE(blink->valid);
  EXPECT_EQ(blink->direction, Vec3(0.0F, 0.0F, -1.0F));
}

}  // namespace
}  // namespace foveola
