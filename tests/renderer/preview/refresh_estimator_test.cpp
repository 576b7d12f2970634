#include "renderer/preview/refresh_estimator.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include "renderer/base/random.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

/// How swaps come about.
struct Display {
  double rate_hz = 59.94;
  double skipped_share = 0.0;   ///< share of refreshes without a swap
  double jitter_s = 1e-3;       ///< swaps are heard of up to so much late
  double straying_share = 0.0;  ///< share of swaps that are heard of up to 8 ms late
  Pcg32 random{7};
  std::int64_t refresh = 0;

  Nanoseconds refresh_time() const {
    return std::chrono::hours(30) +
           nanoseconds_from_seconds(static_cast<double>(refresh) / rate_hz);
  }

  Nanoseconds swap() {
    do {
      ++refresh;
    } while (random.uniform() < skipped_share);
    double late_s = jitter_s * random.uniform();
    if (random.uniform() < straying_share) {
      late_s += 8e-3 * random.uniform();
    }
    return refresh_time() + nanoseconds_from_seconds(late_s);
  }
};

void watch(RefreshEstimator& estimator, Display& display, int swaps) {
  for (int i = 0; i < swaps; ++i) {
    estimator.swap_completed(display.swap());
  }
}

/// How far the refresh that was estimated is behind the true one.
double behind_ms(const RefreshEstimator& estimator, const Display& display) {
  const Nanoseconds refresh = display.refresh_time();
  return 1e3 * seconds(estimator.nearest_refresh(refresh) - refresh);
}

TEST(RefreshEstimator, BeginsWithTheNominalRate) {
  const RefreshEstimator estimator(60.0);
  EXPECT_DOUBLE_EQ(estimator.rate_hz(), 60.0);
  EXPECT_NEAR(seconds(estimator.interval()), 1.0 / 60.0, 1e-9);
  EXPECT_FALSE(estimator.is_measured());
  EXPECT_FALSE(estimator.is_unsynchronised());
  EXPECT_EQ(estimator.nearest_refresh(milliseconds(123)), milliseconds(123));
}

TEST(RefreshEstimator, TheFirstSwapSaysWhereRefreshesAre) {
  RefreshEstimator estimator(100.0);
  estimator.swap_completed(milliseconds(4003));
  EXPECT_EQ(estimator.nearest_refresh(milliseconds(4006)), milliseconds(4003));
  EXPECT_EQ(estimator.nearest_refresh(milliseconds(4009)), milliseconds(4013));
  EXPECT_EQ(estimator.nearest_refresh(milliseconds(3999)), milliseconds(4003));
  EXPECT_EQ(estimator.nearest_refresh(milliseconds(3995)), milliseconds(3993));
}

TEST(RefreshEstimator, MeasuresRateAndPhase) {
  RefreshEstimator estimator(60.0);
  Display display;
  watch(estimator, display, 31);
  EXPECT_FALSE(estimator.is_measured());
  watch(estimator, display, 300);
  EXPECT_TRUE(estimator.is_measured());
  EXPECT_NEAR(estimator.rate_hz(), 59.94, 59.94 * 5e-4);
  for (int i = 0; i < 500; ++i) {
    watch(estimator, display, 1);
    ASSERT_NEAR(behind_ms(estimator, display), 0.5, 0.2) << "half the jitter";
  }
}

TEST(RefreshEstimator, SwapsMayMissRefreshes) {
  RefreshEstimator estimator(60.0);
  Display display{.skipped_share = 0.6};
  watch(estimator, display, 300);
  EXPECT_TRUE(estimator.is_measured());
  EXPECT_NEAR(estimator.rate_hz(), 59.94, 59.94 * 5e-4);
  EXPECT_NEAR(behind_ms(estimator, display), 0.5, 0.2);
}

TEST(RefreshEstimator, SwapsMayStray) {
  for (const double rate_hz : {59.94, 89.9, 143.9}) {
    RefreshEstimator estimator(std::round(rate_hz));
    Display display{.rate_hz = rate_hz, .skipped_share = 0.1, .straying_share = 0.03};
    watch(estimator, display, 2000);
    EXPECT_TRUE(estimator.is_measured()) << rate_hz;
    EXPECT_NEAR(estimator.rate_hz(), rate_hz, rate_hz * 1e-3);
    EXPECT_NEAR(behind_ms(estimator, display), 0.6, 0.4) << rate_hz;
  }
}

TEST(RefreshEstimator, AfterAPauseRefreshesAreFoundAnew) {
  RefreshEstimator estimator(60.0);
  Display display;
  watch(estimator, display, 200);
  display.refresh += 100'000;  // half an hour, in which the rates' difference adds up
  watch(estimator, display, 20);
  EXPECT_TRUE(estimator.is_measured());
  EXPECT_NEAR(behind_ms(estimator, display), 0.5, 0.4);
}

/// Swaps that follow each other after so long, and do not wait.
RefreshEstimator watch_swaps_without_waiting(double nominal_rate_hz, double mean_s,
                                             double variation_s) {
  RefreshEstimator estimator(nominal_rate_hz);
  Pcg32 random(3);
  Nanoseconds now = milliseconds(10);
  for (int i = 0; i < 300; ++i) {
    now += nanoseconds_from_seconds(mean_s + variation_s * (2.0 * random.uniform() - 1.0));
    estimator.swap_completed(now);
  }
  return estimator;
}

TEST(RefreshEstimator, SaysThatSwapsDoNotWait) {
  for (const auto& [mean_ms, variation_ms] : {std::pair{0.05, 0.01},
                                              {0.4, 0.1},
                                              {1.1, 0.0},
                                              {3.0, 0.5},
                                              {7.0, 2.0},
                                              {12.0, 4.0},
                                              {17.0, 9.0},
                                              {40.0, 20.0}}) {
    const RefreshEstimator estimator =
        watch_swaps_without_waiting(70.0, 1e-3 * mean_ms, 1e-3 * variation_ms);
    EXPECT_TRUE(estimator.is_unsynchronised()) << mean_ms;
    EXPECT_FALSE(estimator.is_measured()) << mean_ms;
    EXPECT_DOUBLE_EQ(estimator.rate_hz(), 70.0) << mean_ms;
  }
}

TEST(RefreshEstimator, SaysThatTheDisplayHasAnotherRate) {
  for (const double rate_hz : {50.0, 60.0, 75.0, 144.0}) {
    RefreshEstimator estimator(70.0);
    Display display{.rate_hz = rate_hz};
    watch(estimator, display, 200);
    EXPECT_TRUE(estimator.is_unsynchronised()) << rate_hz;
  }
}

// Frames aim at the refreshes that are estimated and are ready a little before; the swaps that do
// not wait pull the estimate along, so that all go faster and faster.
TEST(RefreshEstimator, IsNotLedByItsOwnFollowers) {
  RefreshEstimator estimator(70.0);
  Pcg32 random(5);
  Nanoseconds aim = milliseconds(100);
  int swaps = 0;
  for (; swaps < 10'000 && !estimator.is_unsynchronised(); ++swaps) {
    const Nanoseconds ready = aim - nanoseconds_from_seconds(1e-3 * random.uniform());
    estimator.swap_completed(ready);
    aim = estimator.nearest_refresh(aim) + estimator.interval();
  }
  EXPECT_TRUE(estimator.is_unsynchronised());
}

}  // namespace
}  // namespace foveola
