#include "study/driver/clock_watch.h"

#include "tests/matchers.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

/// A computer whose clocks the test owns.
struct Computer {
  void run(Nanoseconds duration) {
    clocks.steady += duration;
    clocks.since_boot += duration;
    clocks.since_1970 += duration;
  }
  void sleep(Nanoseconds duration) {
    clocks.since_boot += duration;
    clocks.since_1970 += duration;
  }
  void set_clock(Nanoseconds step) { clocks.since_1970 += step; }

  ClockReadings clocks{.steady = 1h, .since_boot = 30h, .since_1970 = 490'000h};
};

class ClockWatchTest : public ::testing::Test {
 protected:
  std::vector<std::string> notes_after(Nanoseconds duration) {
    computer_.run(duration);
    return watch_.notes_until(computer_.clocks);
  }

  Computer computer_;
  ClockWatch watch_{computer_.clocks};
};

TEST_F(ClockWatchTest, NotesAStepForwardOrBackOnce) {
  EXPECT_THAT(notes_after(1min), IsEmpty());
  computer_.set_clock(5h);
  EXPECT_THAT(
      notes_after(16ms),
      ElementsAre("the computer's clock was set forward by 5 h 00 m while the session ran"));
  EXPECT_THAT(notes_after(1min), IsEmpty());
  computer_.set_clock(-65s);
  EXPECT_THAT(notes_after(16ms),
              ElementsAre("the computer's clock was set back by 1 m 05 s while the session ran"));
}

TEST_F(ClockWatchTest, NotesMoreThanFiveSecondsAndNoLess) {
  computer_.set_clock(5s);
  EXPECT_THAT(notes_after(16ms), IsEmpty());
  computer_.set_clock(-10s);
  EXPECT_THAT(notes_after(16ms), IsEmpty());
  computer_.set_clock(10s + 1ms);
  EXPECT_THAT(notes_after(16ms),
              ElementsAre("the computer's clock was set forward by 5 s while the session ran"));
}

// A time server slews a clock by 0.5 ms a second at most (adjtimex(2)): by 1.8 s in an hour.
TEST_F(ClockWatchTest, DoesNotNoteASlowDrift) {
  for (int second = 0; second < 3600; ++second) {
    computer_.set_clock(500us);
    EXPECT_THAT(notes_after(1s), IsEmpty());
  }
}

TEST_F(ClockWatchTest, NotesASleepAndNoStepBesideIt) {
  computer_.sleep(2min);
  EXPECT_THAT(notes_after(16ms),
              ElementsAre("the computer slept for 2 m 00 s while the session ran"));
  EXPECT_THAT(notes_after(1min), IsEmpty());
}

TEST_F(ClockWatchTest, NotesAClockThatWasSetInASleep) {
  computer_.sleep(2h);
  computer_.set_clock(-1h);
  EXPECT_THAT(notes_after(16ms),
              ElementsAre("the computer slept for 2 h 00 m while the session ran",
                          "the computer's clock was set back by 1 h 00 m while the session ran"));
}

TEST_F(ClockWatchTest, ReadsClocksThatGoOnTogether) {
  ClockWatch watch(read_clocks());
  const ClockReadings now = read_clocks();
  EXPECT_THAT(watch.notes_until(now), IsEmpty());
  EXPECT_GE(now.since_boot, now.steady);
  EXPECT_GT(now.since_1970, 50 * 365 * 24h);
}

}  // namespace
}  // namespace foveola::study
