#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/gaze/device_clocks.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

constexpr Nanoseconds one_us = std::chrono::microseconds(1);

Nanoseconds at_s(double time_s) { return nanoseconds_from_seconds(time_s); }

void expect_near(Nanoseconds time, Nanoseconds expected, Nanoseconds tolerance = one_us) {
  EXPECT_LE(std::chrono::abs(time - expected), tolerance)
      << time.count() << " ns, not " << expected.count();
}

TEST(SensorClock, TheFirstReportCountsFromItsArrival) {
  HidSensorClock clock;
  EXPECT_EQ(clock.host_time(1e9, milliseconds(70)), milliseconds(70));
}

TEST(SensorClock, TakesDelaysOff) {
  HidSensorClock clock;
  clock.host_time(100.000, milliseconds(5000));
  expect_near(clock.host_time(100.010, milliseconds(5017)), milliseconds(5010));
  expect_near(clock.host_time(100.020, milliseconds(5020)), milliseconds(5020));
  // Two milliseconds faster than any before.
  expect_near(clock.host_time(100.030, milliseconds(5028)), milliseconds(5028));
  expect_near(clock.host_time(100.040, milliseconds(5040)), milliseconds(5038));
}

// Sixty seconds at 120 Hz of a clock that runs 100 parts per million slow, with delays that are
// skewed as those of a scheduler are: what is left is what the clocks move apart in the window.
TEST(SensorClock, FollowsAClockThatRunsSlow) {
  HidSensorClock clock;
  Pcg32 random(7, 0);
  Nanoseconds arrival(0);
  for (int i = 0; i < 7200; ++i) {
    const double left_s = i / 120.0;
    const double delay_s = std::min(0.001 * std::pow(random.normal(), 2.0), 0.03);
    arrival = std::max(arrival, at_s(20.0 + left_s + delay_s));
    const Nanoseconds time = clock.host_time(1000.0 + left_s * (1.0 - 1e-4), arrival);
    if (i > 240) {
      expect_near(time, at_s(20.0 + left_s), std::chrono::microseconds(600));
    }
  }
}

TEST(SensorClock, ForgetsTheShortestWayAfterFiveSeconds) {
  HidSensorClock clock;
  clock.host_time(0.0, milliseconds(100));
  for (int i = 1; i <= 9; ++i) {
    // All others take 3 ms more.
    expect_near(clock.host_time(0.5 * i, milliseconds(103 + 500 * i)), milliseconds(100 + 500 * i));
  }
  expect_near(clock.host_time(5.0, milliseconds(5103)), milliseconds(5103));
}

TEST(SensorClock, GoesOnWhenTheSensorsStartsAgain) {
  HidSensorClock clock(4294.967296);  // 32 bits of microseconds
  clock.host_time(4294.9, milliseconds(1000));
  expect_near(clock.host_time(0.032704, milliseconds(1150)), milliseconds(1100));
  expect_near(clock.host_time(1000.032704, milliseconds(1001100)), milliseconds(1001100));
  // And again.
  clock.host_time(4294.95, at_s(4296.05));
  expect_near(clock.host_time(0.002704, at_s(4296.08)), at_s(4296.07));
}

TEST(SensorClock, ComparesAnewWhenTheSensorsJumpsBack) {
  HidSensorClock clock;
  clock.host_time(500.0, milliseconds(1000));
  clock.host_time(500.1, milliseconds(1100));
  EXPECT_EQ(clock.host_time(0.0, milliseconds(1208)), milliseconds(1208));
  expect_near(clock.host_time(0.1, milliseconds(1310)), milliseconds(1308));
}

TEST(SensorClock, FollowsAJumpForwards) {
  HidSensorClock clock;
  clock.host_time(1.0, milliseconds(1000));
  expect_near(clock.host_time(1000.0, milliseconds(1100)), milliseconds(1100));
  expect_near(clock.host_time(1000.1, milliseconds(1205)), milliseconds(1200));
}

// The emulator of the reference code sends seconds where it promises microseconds.
TEST(SensorClock, AClockThatStandsStillMakesNothingOlderThanASecond) {
  HidSensorClock clock;
  for (int i = 0; i < 1000; ++i) {
    const Nanoseconds arrival = milliseconds(10 * i);
    const Nanoseconds time = clock.host_time(1.7e9 * 1e-6, arrival);
    ASSERT_LE(time, arrival);
    ASSERT_GE(time, arrival - std::chrono::seconds(1));
  }
}

}  // namespace
}  // namespace foveola
