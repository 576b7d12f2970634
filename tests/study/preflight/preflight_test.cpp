#include "study/preflight/preflight.h"

#include "study/preflight/system_state.h"
#include "tests/matchers.h"
#include "tests/study/preflight/found_preflight.h"
#include "tests/temporary_folder.h"

namespace foveola::study {
namespace {

using test::found_monitor;
using test::stated_monitor;

TEST(PreflightDisplay, AsStatedWithinARulersError) {
  EXPECT_THAT(display_differences(stated_monitor(), found_monitor()), IsEmpty());
  FoundDisplay silent = found_monitor();
  silent.monitor_width_m = 0.0;
  EXPECT_THAT(display_differences(stated_monitor(), silent), IsEmpty());
}

TEST(PreflightDisplay, AMonitorOfAnotherSizeHasWrongAngles) {
  FoundDisplay found = found_monitor();
  found.monitor_width_m = 0.6375;
  EXPECT_THAT(display_differences(stated_monitor(), found),
              ElementsAre(HasSubstr("angles are wrong by 20 %")));
  found = found_monitor();
  found.monitor_px = {2560, 1440};
  found.monitor_width_m = 0.7084;
  EXPECT_THAT(display_differences(stated_monitor(), found),
              ElementsAre(HasSubstr("2560x1440 pixels, not 1920x1080")));
  found = found_monitor();
  found.refresh_rate_hz = 144.0;
  EXPECT_THAT(display_differences(stated_monitor(), found),
              ElementsAre("it refreshes at 144.0 Hz, not 60.0"));
}

TEST(PreflightDisplay, AHeadsetIsFilledByItsWindow) {
  const DisplayProfile headset{.name = "fove0",
                               .kind = DisplayKind::headset,
                               .width_px = 2560,
                               .height_px = 1440,
                               .refresh_rate_hz = 70.0};
  FoundDisplay found{.window_px = {1280, 720}, .refresh_rate_hz = 70.0};
  EXPECT_TRUE(stands_in_for_headset(headset, found));
  EXPECT_THAT(display_differences(headset, found),
              ElementsAre(HasSubstr("the window has 1280x720")));
  found.window_px = {2560, 1440};
  EXPECT_TRUE(stands_in_for_headset(headset, found));
  found.is_full_screen = true;
  EXPECT_FALSE(stands_in_for_headset(headset, found));
  EXPECT_FALSE(stands_in_for_headset(stated_monitor(), found));
}

TEST(PreflightGaze, WithoutSamplesAllIsLost) {
  EXPECT_EQ(LiveGaze{}.loss(), 1.0);
  EXPECT_EQ(LiveGaze{}.rate_hz(), 0.0);
  EXPECT_DOUBLE_EQ((LiveGaze{.samples = 4, .valid = 3, .duration_s = 0.5}.loss()), 0.25);
}

TEST(SystemState, AFolderHasSpaceForAFileThatIsNotThereYet) {
  const foveola::test::TemporaryFolder folder;
  EXPECT_GT(free_bytes_for(folder / "study.sqlite"), 0U);
}

}  // namespace
}  // namespace foveola::study
