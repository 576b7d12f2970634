#include "renderer/gaze/eye_tracker.h"

#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/gaze_expectations.h"
#include "tests/renderer/gaze/newest_gaze.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using test::NewestGaze;

const Vec3 ahead(0.0F, 0.0F, -1.0F);

TEST(SimulatedEyeTracker, SamplesTheEyeAtItsRateAndDeliversLate) {
  // The eye turns a degree each millisecond.
  const auto eye = [](Nanoseconds time) {
    return direction_from({.azimuth_rad = radians(foveola::seconds(time) * 1000.0)});
  };
  SimulatedEyeTracker tracker({.rate_hz = 100.0, .latency_s = 0.014, .precision_deg = 0.0}, eye);
  NewestGaze newest(tracker);
  EXPECT_FALSE(newest(milliseconds(14) - Nanoseconds(1)));
  for (const auto& [now_ms, exposed_ms] :
       {std::pair{14, 0}, {23, 0}, {24, 10}, {33, 10}, {44, 30}}) {
    const auto sample = newest(milliseconds(now_ms));
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->time, milliseconds(exposed_ms));
    EXPECT_LT(glm::distance(sample->direction, eye(milliseconds(exposed_ms))), 1e-6F);
  }
}

TEST(SimulatedEyeTracker, DeliversEachSampleOnceInOrder) {
  SimulatedEyeTracker tracker({.rate_hz = 100.0, .latency_s = 0.014},
                              [](Nanoseconds) { return ahead; });
  const auto times_ms = [&](int now_ms) {
    std::vector<GazeSample> arrived;
    tracker.poll(milliseconds(now_ms), arrived);
    std::vector<int> times;
    for (const GazeSample& sample : arrived) {
      times.push_back(static_cast<int>(sample.time / milliseconds(1)));
    }
    return times;
  };
  EXPECT_THAT(times_ms(1013), ElementsAre(990)) << "what it saw before it was asked is over";
  EXPECT_THAT(times_ms(1013), IsEmpty());
  EXPECT_THAT(times_ms(1024), ElementsAre(1000, 1010));
  EXPECT_THAT(times_ms(1033), IsEmpty());
  EXPECT_THAT(times_ms(1064), ElementsAre(1020, 1030, 1040, 1050));
}

TEST(EyeTrackers, KeepWhatArrivedBefore) {
  FixedEyeTracker tracker(ahead);
  std::vector<GazeSample> arrived;
  tracker.poll(milliseconds(1), arrived);
  tracker.poll(milliseconds(2), arrived);
  ASSERT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived[0].time, milliseconds(1));
  EXPECT_EQ(arrived[1].time, milliseconds(2));
}

// A third of a second is no number of nanoseconds, and an hour at 120 Hz is many exposures.
TEST(SimulatedEyeTracker, AgesLieBetweenTheLatencyAndAPeriodMore) {
  SimulatedEyeTracker tracker({.rate_hz = 120.0, .latency_s = 0.014},
                              [](Nanoseconds) { return ahead; });
  NewestGaze newest(tracker);
  const Nanoseconds latency = milliseconds(14);
  const Nanoseconds period(8'333'334);
  for (Nanoseconds now = std::chrono::hours(1); now < std::chrono::seconds(3601);
       now += Nanoseconds(1'388'889)) {
    const Nanoseconds age = now - newest(now)->time;
    ASSERT_GE(age, latency);
    ASSERT_LT(age, latency + period);
  }
}

TEST(SimulatedEyeTracker, NoiseHasItsStandardDeviationOnBothAxes) {
  SimulatedEyeTracker tracker(
      {.rate_hz = 1000.0, .latency_s = 0.0, .precision_deg = 0.5, .seed = 3},
      [](Nanoseconds) { return ahead; });
  NewestGaze newest(tracker);
  constexpr int count = 20000;
  double squares_x = 0.0;
  double squares_y = 0.0;
  double products = 0.0;
  double lagged = 0.0;
  double last_x = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto sample = newest(milliseconds(i));
    const double x = degrees(std::atan(-sample->direction.x / sample->direction.z));
    const double y = degrees(std::atan(-sample->direction.y / sample->direction.z));
    squares_x += x * x;
    squares_y += y * y;
    products += x * y;
    lagged += x * last_x;
    last_x = x;
  }
  EXPECT_NEAR(std::sqrt(squares_x / count), 0.5, 0.02);
  EXPECT_NEAR(std::sqrt(squares_y / count), 0.5, 0.02);
  EXPECT_NEAR(products / count / 0.25, 0.0, 5.0 / std::sqrt(count));
  EXPECT_NEAR(lagged / count / 0.25, 0.0, 5.0 / std::sqrt(count));
}

TEST(SimulatedEyeTracker, BiasIsAddedToBothAngles) {
  const AzimuthElevation true_gaze{.azimuth_rad = radians(12.0), .elevation_rad = radians(-7.0)};
  SimulatedEyeTracker tracker(
      {.latency_s = 0.0, .precision_deg = 0.0, .bias_right_deg = 1.5, .bias_up_deg = -0.5},
      [&](Nanoseconds) { return direction_from(true_gaze); });
  NewestGaze newest(tracker);
  const AzimuthElevation seen = azimuth_elevation(newest(milliseconds(0))->direction);
  EXPECT_NEAR(degrees(seen.azimuth_rad), 13.5, 1e-5);
  EXPECT_NEAR(degrees(seen.elevation_rad), -7.5, 1e-5);
}

TEST(SimulatedEyeTracker, LosesItsPartOfTheSamples) {
  SimulatedEyeTracker tracker({.rate_hz = 1000.0, .latency_s = 0.0, .data_loss = 0.2, .seed = 5},
                              [](Nanoseconds) { return ahead; });
  NewestGaze newest(tracker);
  constexpr int count = 20000;
  int lost = 0;
  for (int i = 0; i < count; ++i) {
    lost += newest(milliseconds(i))->valid ? 0 : 1;
  }
  EXPECT_NEAR(lost, 0.2 * count, 5.0 * std::sqrt(0.2 * 0.8 * count));
}

TEST(SimulatedEyeTracker, WhatIsNotLostIsSeenAsIfNothingWere) {
  SimulatedTrackerSettings settings{.rate_hz = 1000.0, .latency_s = 0.0, .seed = 6};
  SimulatedEyeTracker whole(settings, [](Nanoseconds) { return ahead; });
  NewestGaze newest_whole(whole);
  settings.data_loss = 0.5;
  SimulatedEyeTracker lossy(settings, [](Nanoseconds) { return ahead; });
  NewestGaze newest_lossy(lossy);
  for (int i = 0; i < 1000; ++i) {
    const auto sample = newest_lossy(milliseconds(i));
    const auto expected = newest_whole(milliseconds(i));
    ASSERT_TRUE(expected->valid);
    ASSERT_TRUE(!sample->valid || sample->direction == expected->direction);
  }
}

TEST(SimulatedEyeTracker, NoiseDoesNotDependOnWhenItIsPolled) {
  const SimulatedTrackerSettings settings{.rate_hz = 100.0, .latency_s = 0.01, .seed = 9};
  const auto eye = [](Nanoseconds) { return ahead; };
  SimulatedEyeTracker often(settings, eye);
  NewestGaze newest_often(often);
  SimulatedEyeTracker once(settings, eye);
  NewestGaze newest_once(once);
  for (int now_ms = 0; now_ms < 500; ++now_ms) {
    newest_often(milliseconds(now_ms));
  }
  EXPECT_EQ(newest_often(milliseconds(500))->direction, newest_once(milliseconds(500))->direction);
}

TEST(SimulatedEyeTracker, ABlinkIsAnInvalidSample) {
  SimulatedEyeTracker tracker({.rate_hz = 100.0, .latency_s = 0.0}, [](Nanoseconds time) {
    return time < milliseconds(50) ? std::optional(ahead) : std::nullopt;
  });
  NewestGaze newest(tracker);
  EXPECT_TRUE(newest(milliseconds(45))->valid);
  EXPECT_FALSE(newest(milliseconds(65))->valid);
}

std::vector<GazeSample> numbered(int first, int count) {
  std::vector<GazeSample> samples;
  for (int i = 0; i < count; ++i) {
    samples.push_back({.time = Nanoseconds(first + i)});
  }
  return samples;
}

TEST(SampleQueue, GivesAllInOrderOnce) {
  SampleQueue queue;
  queue.push(numbered(1, 2));
  queue.push(numbered(3, 1));
  std::vector<GazeSample> arrived = numbered(0, 1);
  queue.take(arrived);
  ASSERT_EQ(arrived.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(arrived[i].time, Nanoseconds(i));
  }
  queue.take(arrived);
  EXPECT_EQ(arrived.size(), 4U);
}

TEST(SampleQueue, KeepsTheNewestWhileNobodyTakesThem) {
  constexpr int count = 1'000'000;
  SampleQueue queue;
  for (int i = 0; i < count; ++i) {
    queue.push(numbered(i, 1));
  }
  std::vector<GazeSample> arrived;
  queue.take(arrived);
  ASSERT_LE(arrived.size(), SampleQueue::capacity);
  ASSERT_GE(arrived.size(), SampleQueue::capacity / 2);
  for (std::size_t i = 0; i < arrived.size(); ++i) {
    ASSERT_EQ(arrived[arrived.size() - 1 - i].time, Nanoseconds(count - 1 - static_cast<int>(i)));
  }
}

// A screen of 0.6 m x 0.3 m that is seen from 0.3 m fills 90 degrees and 53.13 degrees.
constexpr Screen near_screen{.width_m = 0.6,
                             .height_m = 0.3,
                             .horizontal_fov_deg = 90.0,
                             .vertical_fov_deg = 53.13010235415598};

TEST(Screen, ItsMiddleIsAhead) { expect_along(direction_at(near_screen, {0.5, 0.5}), {0, 0, -1}); }

TEST(Screen, ItsCornersAreAtTheViewsEdges) {
  expect_along(direction_at(near_screen, {0.0, 0.0}), {-0.3F, 0.15F, -0.3F});
  expect_along(direction_at(near_screen, {1.0, 1.0}), {0.3F, -0.15F, -0.3F});
}

TEST(Screen, GoesOnBeyondItsEdges) {
  expect_along(direction_at(near_screen, {1.5, 0.5}), {0.6F, 0.0F, -0.3F});
}

TEST(Screen, MetresAreFromTheTopLeft) {
  const DVec2 fraction = fraction_of(near_screen, {0.15, 0.225});
  EXPECT_DOUBLE_EQ(fraction.x, 0.25);
  EXPECT_DOUBLE_EQ(fraction.y, 0.75);
}

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
