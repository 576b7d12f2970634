#include "renderer/headset/headset_motion.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

using std::chrono::milliseconds;

Quat turned_right(double azimuth_deg) {
  return head_orientation({.azimuth_rad = radians(azimuth_deg)});
}

double azimuth_deg(const std::optional<Quat>& head) {
  return degrees(azimuth_elevation(head.value() * Vec3(0.0F, 0.0F, -1.0F)).azimuth_rad);
}

TEST(HeadsetMotion, KnowsNothingAtFirst) {
  HeadsetMotion motion;
  EXPECT_FALSE(motion.head_at(milliseconds(1)));
  motion.face({.azimuth_rad = radians(30.0), .elevation_rad = 0.5});
  HeadsetHead head(motion);
  EXPECT_NEAR(degrees(head.pose(milliseconds(1)).heading.azimuth_rad), 30.0, 1e-3);
  EXPECT_NEAR(head.pose(milliseconds(1)).heading.elevation_rad, 0.0, 1e-6)
      << "the horizon is level";
}

TEST(HeadsetMotion, IsEvenBetweenWhatIsKnown) {
  HeadsetMotion motion;
  motion.head_was(milliseconds(100), turned_right(10.0));
  motion.head_was(milliseconds(110), turned_right(20.0));
  EXPECT_NEAR(azimuth_deg(motion.head_at(milliseconds(105))), 15.0, 1e-3);
  EXPECT_NEAR(azimuth_deg(motion.head_at(milliseconds(0))), 10.0, 1e-3);
  EXPECT_NEAR(azimuth_deg(motion.head_at(milliseconds(500))), 20.0, 1e-3);
}

TEST(HeadsetMotion, BelievesWhatIsSeenRatherThanWhatWasForetold) {
  HeadsetMotion motion;
  motion.head_was(milliseconds(100), turned_right(0.0));
  motion.head_was(milliseconds(125), turned_right(50.0));
  motion.head_was(milliseconds(110), turned_right(1.0));
  EXPECT_NEAR(azimuth_deg(motion.head_at(milliseconds(125))), 1.0, 1e-3);
}

TEST(HeadsetMotion, TurnsWithTheRoom) {
  HeadsetMotion motion;
  motion.face({.azimuth_rad = radians(90.0)});
  motion.head_was(milliseconds(100), turned_right(10.0));
  EXPECT_NEAR(azimuth_deg(motion.head_at(milliseconds(100))), 100.0, 1e-3);
}

TEST(HeadsetMotion, KeepsTheNewestOfLongSessions) {
  HeadsetMotion motion;
  constexpr int frames = 10'000;
  for (int i = 0; i < frames; ++i) {
    motion.head_was(milliseconds(i), turned_right(0.01 * i));
  }
  EXPECT_NEAR(azimuth_deg(motion.head_at(milliseconds(frames - 100))), 0.01 * (frames - 100), 1e-2);
}

TEST(HeadsetMotion, PassesGazeOnAndKnowsWhereItIsInTheWorld) {
  HeadsetMotion motion;
  motion.head_was(milliseconds(100), turned_right(10.0));
  motion.head_was(milliseconds(110), turned_right(20.0));
  const GazeSample sample{.time = milliseconds(105),
                          .direction = direction_from({.azimuth_rad = radians(5.0)}),
                          .valid = true};
  motion.gaze_came(sample);
  EXPECT_LT(degrees(angle_between(motion.newest_gaze().value(),
                                  direction_from({.azimuth_rad = radians(20.0)}))),
            1e-3);
  HeadsetEyes eyes(motion, true);
  std::vector<GazeSample> arrived;
  eyes.poll(milliseconds(111), arrived);
  eyes.poll(milliseconds(112), arrived);
  ASSERT_EQ(arrived.size(), 1U);
  EXPECT_EQ(arrived.front().time, sample.time);
  motion.gaze_came({.time = milliseconds(116)});
  EXPECT_FALSE(motion.newest_gaze()) << "in a blink";
}

TEST(HeadsetEyes, SayThatThereIsNoTracker) {
  HeadsetMotion motion;
  EXPECT_NE(HeadsetEyes(motion, false).status(), "");
  EXPECT_EQ(HeadsetEyes(motion, true).status(), "");
}

}  // namespace
}  // namespace foveola
