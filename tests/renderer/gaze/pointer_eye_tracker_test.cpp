#include "renderer/gaze/pointer_eye_tracker.h"

#include <thread>

#include <gtest/gtest.h>

#include "tests/renderer/gaze/newest_gaze.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using test::NewestGaze;

const Vec3 to_the_right(1.0F, 0.0F, 0.0F);
const Vec3 upwards(0.0F, 1.0F, 0.0F);

TEST(PointerEyeTracker, KnowsNothingBeforeTheFirstEvent) {
  PointerEyeTracker pointer;
  NewestGaze newest(pointer);
  EXPECT_FALSE(newest(milliseconds(5)));
}

TEST(PointerEyeTracker, LooksWhereItWasMovedToLast) {
  PointerEyeTracker pointer;
  NewestGaze newest(pointer);
  pointer.point_at(milliseconds(1), to_the_right);
  pointer.point_at(milliseconds(2), upwards);
  const auto sample = newest(milliseconds(5));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->valid);
  EXPECT_EQ(sample->direction, upwards);
}

TEST(PointerEyeTracker, IsKnownToRestWhereItIs) {
  PointerEyeTracker pointer;
  NewestGaze newest(pointer);
  pointer.point_at(milliseconds(1), to_the_right);
  EXPECT_EQ(newest(milliseconds(5))->time, milliseconds(5));
  EXPECT_EQ(newest(milliseconds(7005))->time, milliseconds(7005));
  EXPECT_EQ(newest(milliseconds(7005))->direction, to_the_right);
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
