#include "renderer/gaze/gaze_filter.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/random.h"
#include "renderer/gaze/recorded_eye_tracker.h"
#include "renderer/gaze/simulated_eye.h"
#include "tests/renderer/gaze/newest_gaze.h"

namespace foveola {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using test::NewestGaze;

Vec3 at_deg(double azimuth_deg) { return direction_from({.azimuth_rad = radians(azimuth_deg)}); }
double azimuth_deg(const Vec3& direction) {
  return degrees(azimuth_elevation(direction).azimuth_rad);
}

GazeSample seen_at(int time_ms, double azimuth_deg) {
  return {.time = milliseconds(time_ms), .direction = at_deg(azimuth_deg), .valid = true};
}
GazeSample blink_at(int time_ms) { return {.time = milliseconds(time_ms)}; }

std::unique_ptr<EyeTracker> recorded(std::vector<GazeSample> samples) {
  return std::make_unique<RecordedEyeTracker>(std::move(samples), Nanoseconds(0), Nanoseconds(0));
}

TEST(HoldFilter, PassesValidSamplesOn) {
  HoldFilter held(recorded({seen_at(10, 1.0), seen_at(20, 2.0)}));
  NewestGaze newest(held);
  EXPECT_FALSE(newest(milliseconds(9)));
  EXPECT_EQ(newest(milliseconds(15))->time, milliseconds(10));
  EXPECT_EQ(newest(milliseconds(20))->time, milliseconds(20));
}

TEST(HoldFilter, HoldsTheLastValidOneWithItsOwnTime) {
  HoldFilter held(recorded({seen_at(10, 1.0), blink_at(20), blink_at(30), seen_at(200, 5.0)}));
  NewestGaze newest(held);
  newest(milliseconds(10));
  const auto sample = newest(milliseconds(100));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->valid);
  EXPECT_EQ(sample->direction, at_deg(1.0));
  EXPECT_EQ(sample->time, milliseconds(10));
  EXPECT_EQ(newest(milliseconds(200))->direction, at_deg(5.0));
}

TEST(HoldFilter, LetsGoAfterSixHundredMilliseconds) {
  HoldFilter held(recorded({seen_at(10, 1.0), blink_at(20)}));
  NewestGaze newest(held);
  newest(milliseconds(10));
  EXPECT_TRUE(newest(milliseconds(610))->valid);
  EXPECT_FALSE(newest(milliseconds(610) + Nanoseconds(1))->valid);
}

TEST(HoldFilter, LetsGoOfATrackerThatHasStopped) {
  HoldFilter held(recorded({seen_at(10, 1.0)}), milliseconds(100));
  NewestGaze newest(held);
  EXPECT_TRUE(newest(milliseconds(110))->valid);
  EXPECT_FALSE(newest(milliseconds(111))->valid);
}

TEST(HoldFilter, KeepsInvalidSamplesBackWhileItHoldsAndReportsTheEnd) {
  HoldFilter held(recorded({seen_at(10, 1.0), blink_at(20), blink_at(30), blink_at(640)}));
  const auto polled = [&](int now_ms) {
    std::vector<GazeSample> arrived;
    held.poll(milliseconds(now_ms), arrived);
    return arrived;
  };
  const auto first = polled(100);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].time, milliseconds(10));
  const auto end = polled(615);
  ASSERT_EQ(end.size(), 1U);
  EXPECT_FALSE(end[0].valid);
  EXPECT_EQ(end[0].time, milliseconds(615));
  const auto after = polled(640);
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(after[0].time, milliseconds(640));
  EXPECT_TRUE(polled(700).empty());
}

TEST(HoldFilter, WithoutAnyValidSampleThereIsNone) {
  HoldFilter held(recorded({blink_at(10)}));
  NewestGaze newest(held);
  EXPECT_FALSE(newest(milliseconds(10))->valid);
}

/// What becomes of these azimuths.
std::vector<double> smoothed_deg(const OneEuroSettings& settings, const std::vector<int>& times_ms,
                                 const std::vector<double>& azimuths_deg) {
  OneEuro filter(settings);
  std::vector<double> result;
  for (std::size_t i = 0; i < times_ms.size(); ++i) {
    result.push_back(
        azimuth_deg(filter.smoothed(milliseconds(times_ms[i]), at_deg(azimuths_deg[i]))));
  }
  return result;
}

// By the paper's algorithm for numbers, written down in another language; the intervals differ.
TEST(OneEuro, IsThePublishedFilterAlongAGreatCircle) {
  const std::vector<int> times_ms{0, 8, 17, 25, 50, 58, 70};
  const std::vector<double> azimuths_deg{0.0, 0.5, -0.3, 4.0, 12.0, 12.1, 11.9};
  const std::vector<double> expected{0.0,
                                     0.058613353571966,
                                     0.026890647240297303,
                                     1.4223112038688575,
                                     10.084182879070717,
                                     11.310387840159102,
                                     11.711989236757995};
  const auto result =
      smoothed_deg({.min_cutoff_hz = 1.5, .beta_per_deg = 0.2, .derivative_cutoff_hz = 2.0},
                   times_ms, azimuths_deg);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(result[i], expected[i], 1e-5) << i;
  }
}

// An exponential low pass leaves (1 - alpha)^n of a step after n samples.
TEST(OneEuro, WithoutBetaIsAnExponentialLowPass) {
  OneEuro filter({.min_cutoff_hz = 2.0, .beta_per_deg = 0.0});
  filter.smoothed(Nanoseconds(0), at_deg(0.0));
  const double alpha = 1.0 / (1.0 + 1.0 / (2.0 * std::numbers::pi * 2.0 * 0.01));
  for (int n = 1; n <= 100; ++n) {
    const double left_deg = 10.0 - azimuth_deg(filter.smoothed(n * milliseconds(10), at_deg(10.0)));
    EXPECT_NEAR(left_deg, 10.0 * std::pow(1.0 - alpha, n), 1e-4);
  }
}

TEST(OneEuro, TurnsAlikeInAllDirections) {
  const Vec3 from = glm::normalize(Vec3(0.3F, 0.8F, 0.1F));
  const Vec3 to = glm::normalize(Vec3(0.2F, 0.9F, 0.2F));
  OneEuro along_equator({});
  OneEuro elsewhere({});
  const double step_deg = degrees(angle_between(from, to));
  along_equator.smoothed(Nanoseconds(0), at_deg(0.0));
  elsewhere.smoothed(Nanoseconds(0), from);
  for (int n = 1; n < 10; ++n) {
    const double expected_deg =
        azimuth_deg(along_equator.smoothed(n * milliseconds(8), at_deg(step_deg)));
    const Vec3 direction = elsewhere.smoothed(n * milliseconds(8), to);
    EXPECT_NEAR(degrees(angle_between(from, direction)), expected_deg, 1e-4);
    EXPECT_NEAR(degrees(angle_between(direction, to)), step_deg - expected_deg, 1e-4);
  }
}

TEST(OneEuro, TheSameSampleAgainChangesNothing) {
  OneEuro filter({});
  filter.smoothed(milliseconds(0), at_deg(0.0));
  const Vec3 once = filter.smoothed(milliseconds(8), at_deg(3.0));
  EXPECT_EQ(filter.smoothed(milliseconds(8), at_deg(3.0)), once);
}

TEST(OneEuro, BeginsAnewAfterAGapAndWhenTimeGoesBack) {
  OneEuro filter({.reset_after = milliseconds(50)});
  filter.smoothed(milliseconds(0), at_deg(0.0));
  EXPECT_LT(azimuth_deg(filter.smoothed(milliseconds(50), at_deg(8.0))), 7.9);
  EXPECT_NEAR(azimuth_deg(filter.smoothed(milliseconds(101), at_deg(-9.0))), -9.0, 1e-5);
  EXPECT_NEAR(azimuth_deg(filter.smoothed(milliseconds(100), at_deg(4.0))), 4.0, 1e-5);
}

// What its defaults are said to do.
TEST(OneEuro, QuietensAnEyeAtRestAndFollowsASaccade) {
  OneEuro filter({});
  Pcg32 random(4);
  double noise = 0.0;
  double rest = 0.0;
  Nanoseconds time{0};
  for (int i = 0; i < 5000; ++i, time += microseconds(8333)) {
    const double azimuth = 0.1 * random.normal();
    const double smooth = azimuth_deg(filter.smoothed(time, at_deg(azimuth)));
    noise += azimuth * azimuth;
    rest += smooth * smooth;
  }
  EXPECT_NEAR(std::sqrt(rest / noise), 0.33, 0.03);

  const double duration_s = saccade_duration_s(10.0);
  const Nanoseconds start = time;
  double left_deg = 10.0;
  for (; foveola::seconds(time - start) < duration_s; time += microseconds(8333)) {
    const double gone_deg =
        saccade_progress_deg(10.0, foveola::seconds(time - start) - 0.5 * duration_s);
    left_deg = 10.0 - azimuth_deg(filter.smoothed(time, at_deg(gone_deg)));
  }
  EXPECT_NEAR(left_deg, 0.4, 0.1);
}

TEST(OneEuroFilter, SmoothsAllThatArriveTogether) {
  OneEuroFilter smooth(recorded({seen_at(0, 0.0), seen_at(8, 1.0), seen_at(16, 2.0)}), {});
  OneEuro filter({});
  std::vector<GazeSample> arrived;
  smooth.poll(milliseconds(16), arrived);
  ASSERT_EQ(arrived.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(arrived[i].direction, filter.smoothed(milliseconds(8 * i), at_deg(i)));
  }
}

TEST(OneEuroFilter, SmoothsWhatPassesAndLeavesBlinksAlone) {
  OneEuroFilter smooth(recorded({seen_at(0, 0.0), seen_at(8, 1.0), blink_at(16), seen_at(24, 1.0)}),
                       {});
  NewestGaze newest(smooth);
  OneEuro filter({});
  EXPECT_FALSE(newest(-milliseconds(1)));
  EXPECT_EQ(newest(milliseconds(0))->direction, filter.smoothed(milliseconds(0), at_deg(0.0)));
  const Vec3 second = filter.smoothed(milliseconds(8), at_deg(1.0));
  EXPECT_EQ(newest(milliseconds(8))->direction, second);
  EXPECT_EQ(newest(milliseconds(12))->direction, second);
  EXPECT_EQ(newest(milliseconds(12))->time, milliseconds(8));
  EXPECT_FALSE(newest(milliseconds(16))->valid);
  EXPECT_EQ(newest(milliseconds(24))->direction, filter.smoothed(milliseconds(24), at_deg(1.0)));
}

TEST(Filtered, ByDefaultIsTheTrackerItself) {
  auto tracker = recorded({seen_at(0, 0.0)});
  const EyeTracker* const before = tracker.get();
  EXPECT_EQ(filtered(std::move(tracker), {}).get(), before);
}

TEST(Filtered, HoldsWhatIsSmoothed) {
  const auto tracker = filtered(recorded({seen_at(0, 0.0), seen_at(8, 1.0), blink_at(16)}),
                                {.hold = milliseconds(300), .one_euro = OneEuroSettings{}});
  NewestGaze newest(*tracker);
  newest(milliseconds(0));
  const auto second = newest(milliseconds(8));
  EXPECT_LT(azimuth_deg(second->direction), 0.9);
  const auto third = newest(milliseconds(16));
  EXPECT_TRUE(third->valid);
  EXPECT_EQ(third->direction, second->direction);
}

}  // namespace
}  // namespace foveola
