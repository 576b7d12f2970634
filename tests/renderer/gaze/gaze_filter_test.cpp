#include "renderer/gaze/gaze_filter.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/gaze/simulated_eye.h"
#include "tests/renderer/gaze/gaze_expectations.h"

namespace foveola {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using test::at_deg;
using test::lost_at;
using test::seen_at;

double azimuth_deg(const Vec3& direction) {
  return degrees(azimuth_elevation(direction).azimuth_rad);
}

/// Samples that arrive at their own times, and what a filter makes of them.
class FilteredStream {
 public:
  FilteredStream(const GazeFilterSettings& settings, std::vector<GazeSample> samples)
      : filter_(settings), samples_(std::move(samples)) {}

  std::vector<GazeSample> polled(Nanoseconds now) {
    std::vector<GazeSample> arrived;
    for (; next_ < samples_.size() && samples_[next_].time <= now; ++next_) {
      arrived.push_back(samples_[next_]);
    }
    const std::vector<GazeSample> filtered = filter_.filtered(now, arrived);
    if (!filtered.empty()) {
      newest_ = filtered.back();
    }
    return filtered;
  }

  /// The newest that has passed by `now`; empty before the first.
  std::optional<GazeSample> newest(Nanoseconds now) {
    polled(now);
    return newest_;
  }

 private:
  GazeFilter filter_;
  std::vector<GazeSample> samples_;
  std::size_t next_ = 0;
  std::optional<GazeSample> newest_;
};

FilteredStream held(std::vector<GazeSample> samples, Nanoseconds limit = longest_hold) {
  return {{.hold_s = foveola::seconds(limit)}, std::move(samples)};
}

TEST(GazeHold, HoldsTheLastValidOneWithItsOwnTime) {
  FilteredStream stream = held({seen_at(10, 1.0), lost_at(20), lost_at(30), seen_at(200, 5.0)});
  stream.newest(milliseconds(10));
  const auto sample = stream.newest(milliseconds(100));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->valid);
  EXPECT_EQ(sample->direction, at_deg(1.0));
  EXPECT_EQ(sample->time, milliseconds(10));
  EXPECT_EQ(stream.newest(milliseconds(200))->direction, at_deg(5.0));
}

TEST(GazeHold, LetsGoAfterSixHundredMilliseconds) {
  FilteredStream stream = held({seen_at(10, 1.0), lost_at(20)});
  stream.newest(milliseconds(10));
  EXPECT_TRUE(stream.newest(milliseconds(610))->valid);
  EXPECT_FALSE(stream.newest(milliseconds(610) + Nanoseconds(1))->valid);
}

TEST(GazeHold, LetsGoOfATrackerThatHasStopped) {
  FilteredStream stream = held({seen_at(10, 1.0)}, milliseconds(100));
  EXPECT_TRUE(stream.newest(milliseconds(110))->valid);
  EXPECT_FALSE(stream.newest(milliseconds(111))->valid);
}

TEST(GazeHold, KeepsInvalidSamplesBackWhileItHoldsAndReportsTheEnd) {
  FilteredStream stream = held({seen_at(10, 1.0), lost_at(20), lost_at(30), lost_at(640)});
  const auto first = stream.polled(milliseconds(100));
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].time, milliseconds(10));
  const auto end = stream.polled(milliseconds(615));
  ASSERT_EQ(end.size(), 1U);
  EXPECT_FALSE(end[0].valid);
  EXPECT_EQ(end[0].time, milliseconds(615));
  const auto after = stream.polled(milliseconds(640));
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(after[0].time, milliseconds(640));
  EXPECT_TRUE(stream.polled(milliseconds(700)).empty());
}

TEST(GazeHold, WithoutAnyValidSampleThereIsNone) {
  EXPECT_FALSE(held({lost_at(10)}).newest(milliseconds(10))->valid);
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

TEST(GazeFilter, WithoutAnyLeavesSamplesAsTheyAre) {
  GazeFilter none({});
  const std::vector<GazeSample> samples{seen_at(0, 1.0), lost_at(8), seen_at(16, 3.0)};
  const std::vector<GazeSample> passed = none.filtered(milliseconds(20), samples);
  ASSERT_EQ(passed.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(passed[i].time, samples[i].time);
    EXPECT_EQ(passed[i].direction, samples[i].direction);
    EXPECT_EQ(passed[i].valid, samples[i].valid);
  }
}

/// A pursuit with noise, whose samples come 8 ms apart, and a blink from 400 to 500 ms.
std::vector<GazeSample> pursuit_with_a_blink() {
  Pcg32 random(8);
  std::vector<GazeSample> samples;
  for (int time_ms = 0; time_ms < 800; time_ms += 8) {
    const bool is_blink = time_ms >= 400 && time_ms < 500;
    samples.push_back(is_blink ? lost_at(time_ms)
                               : seen_at(time_ms, 0.02 * time_ms + 0.1 * random.normal()));
  }
  return samples;
}

const GazeFilterSettings all_filters{
    .one_euro = OneEuroSettings{}, .extrapolate_s = 0.04, .hold_s = 0.3};

TEST(GazeFilter, SmoothsExtrapolatesAndThenHolds) {
  const std::vector<GazeSample> samples = pursuit_with_a_blink();
  FilteredStream stream(all_filters, samples);
  OneEuro one_euro({});
  GazeExtrapolation extrapolation(milliseconds(40));
  std::optional<GazeSample> expected;
  for (const GazeSample& sample : samples) {
    if (sample.valid) {
      expected = sample;
      expected->direction = one_euro.smoothed(sample.time, sample.direction);
      expected->direction = extrapolation.extrapolated(*expected);
    }
    const std::optional<GazeSample> newest = stream.newest(sample.time);
    ASSERT_TRUE(newest);
    EXPECT_TRUE(newest->valid);
    EXPECT_EQ(newest->time, expected->time) << "its own, whatever was done to it";
    EXPECT_EQ(newest->direction, expected->direction);
  }
  EXPECT_GT(degrees(angle_between(samples.back().direction, expected->direction)), 0.1);
}

TEST(GazeFilter, DoesTheSameToSamplesOneByOneAndInBatches) {
  const std::vector<GazeSample> samples = pursuit_with_a_blink();
  FilteredStream one_by_one(all_filters, samples);
  FilteredStream in_batches(all_filters, samples);
  std::vector<GazeSample> singly;
  std::vector<GazeSample> together;
  for (int time_ms = 0; time_ms < 800; ++time_ms) {
    const std::vector<GazeSample> passed = one_by_one.polled(milliseconds(time_ms));
    singly.insert(singly.end(), passed.begin(), passed.end());
    if (time_ms % 50 == 49) {
      const std::vector<GazeSample> batch = in_batches.polled(milliseconds(time_ms));
      together.insert(together.end(), batch.begin(), batch.end());
    }
  }
  ASSERT_EQ(singly.size(), 87U) << "100 less those of the blink";
  ASSERT_EQ(together.size(), singly.size());
  for (std::size_t i = 0; i < singly.size(); ++i) {
    EXPECT_EQ(together[i].time, singly[i].time);
    EXPECT_EQ(together[i].direction, singly[i].direction);
  }
}

}  // namespace
}  // namespace foveola
