#include "renderer/gaze/gaze_source.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/newest_gaze.h"
#include "tests/temporary_folder.h"
#include "tracker_server.h"

namespace foveola {
namespace {

using test::NewestGaze;

const Screen screen{
    .width_m = 0.5, .height_m = 0.3, .horizontal_fov_deg = 50.0, .vertical_fov_deg = 30.0};

TEST(GazeSource, DelaysCountFromTheMiddleOfAnExposure) {
  EXPECT_EQ(shortest_delay(read_tracker_profile("fove0")), std::chrono::milliseconds(10));
}

TEST(GazeSource, ASimulatedTrackerWatchesASimulatedEye) {
  VirtualClock clock;
  clock.advance(std::chrono::hours(1));
  TrackerProfile profile = read_tracker_profile("fove0");
  const auto tracker = open_eye_tracker(profile, screen, clock);
  NewestGaze newest(*tracker);
  EXPECT_EQ(tracker->status(), "");
  clock.advance(std::chrono::seconds(1));
  const auto sample = newest(clock.now());
  ASSERT_TRUE(sample);
  EXPECT_LE(clock.now() - sample->time, std::chrono::milliseconds(23)) << "a period and 14 ms";
  EXPECT_NEAR(glm::length(sample->direction), 1.0F, 1e-5F);
}

TEST(GazeSource, ARecordingBeginsWhenItIsOpened) {
  const test::TemporaryFolder folder;
  TrackerProfile profile = read_tracker_profile("fove0");
  profile.source = TrackerSource::recorded;
  profile.recording = folder.write("gaze.csv", "time_ns,x,y,z,valid\n5000000,1,0,0,1\n");
  VirtualClock clock;
  clock.advance(std::chrono::hours(1));
  const auto tracker = open_eye_tracker(profile, screen, clock);
  NewestGaze newest(*tracker);
  // Of the profile's delays, 10 ms.
  EXPECT_FALSE(newest(clock.now() + std::chrono::microseconds(14'999)));
  const auto sample = newest(clock.now() + std::chrono::milliseconds(15));
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->time, clock.now() + std::chrono::milliseconds(5));
  EXPECT_EQ(sample->direction, Vec3(1.0F, 0.0F, 0.0F));
}

TEST(GazeSource, AWindowsPointerIsMovedByTheWindow) {
  const SteadyClock clock;
  const WindowEyeTracker opened =
      open_window_eye_tracker(read_tracker_profile("pointer"), screen, clock);
  ASSERT_NE(opened.pointer, nullptr);
  opened.pointer->point_at(Nanoseconds(1), Vec3(1.0F, 0.0F, 0.0F));
  NewestGaze newest(*opened.tracker);
  const auto sample = newest(Nanoseconds(2));
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->direction, Vec3(1.0F, 0.0F, 0.0F));
  EXPECT_EQ(open_window_eye_tracker(read_tracker_profile("fove0"), screen, clock).pointer, nullptr);
}

TEST(GazeSource, WithoutAWindowThereIsNoPointer) {
  const SteadyClock clock;
  EXPECT_THROW(open_eye_tracker(read_tracker_profile("pointer"), screen, clock), Error);
}

TEST(GazeSource, SaysThatNobodySpeaksOpenGaze) {
  const test::TrackerServer nobody(test::TrackerServer::Begin::later);
  TrackerProfile profile = read_tracker_profile("open-gaze");
  profile.open_gaze.port = nobody.port();
  const SteadyClock clock;
  const auto tracker = open_eye_tracker(profile, screen, clock);
  NewestGaze newest(*tracker);
  EXPECT_FALSE(newest(clock.now()));
  EXPECT_THAT(tracker->status(), HasSubstr("127.0.0.1:"));
}

}  // namespace
}  // namespace foveola
