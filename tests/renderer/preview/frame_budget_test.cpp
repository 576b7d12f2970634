#include "renderer/preview/frame_budget.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

constexpr Nanoseconds frame_time{14'285'714};  // 70 Hz

/// A machine whose costs vary by up to so much of themselves, and which now and then does something
/// else for a while.
struct Machine {
  double sample_s = 2e-6;
  double batch_s = 0.0;  ///< cost of a batch, whatever its size
  double rest_s = 3e-3;
  double variation = 0.1;
  double disturbed_share = 0.0;
  double longest_disturbance_s = 1e-3;
  Pcg32 random{5};

  Nanoseconds disturbance() {
    const bool is_disturbed = random.uniform() < disturbed_share;
    return nanoseconds_from_seconds(is_disturbed ? longest_disturbance_s * random.uniform() : 0.0);
  }

  Nanoseconds take(double cost_s) {
    const double factor = 1.0 + variation * (2.0 * random.uniform() - 1.0);
    return nanoseconds_from_seconds(cost_s * factor);
  }
};

struct Frame {
  Nanoseconds took{0};
  Nanoseconds tracing{0};  ///< the part that is tracing
  std::uint64_t samples = 0;
};

Frame run_frame(FrameBudget& budget, Machine& machine) {
  Frame frame;
  const auto trace = [&](std::uint64_t samples) {
    if (samples > 0) {
      const Nanoseconds time = nanoseconds_from_seconds(machine.batch_s) +
                               machine.take(machine.sample_s * static_cast<double>(samples));
      budget.batch_took(samples, time);
      frame.took += time;
      frame.samples += samples;
    }
  };
  trace(budget.first_batch(frame_time));
  trace(budget.next_batch(frame_time - frame.took));
  trace(budget.next_batch(frame_time - frame.took));
  frame.tracing = frame.took;
  const Nanoseconds rest = machine.take(machine.rest_s);
  budget.rest_took(rest);
  frame.took += rest + machine.disturbance();
  budget.frame_ended(frame.took > frame_time);
  return frame;
}

TEST(CostEstimate, FollowsRfc6298) {
  CostEstimate cost;
  EXPECT_TRUE(cost.empty());
  cost.add(8.0);
  EXPECT_DOUBLE_EQ(cost.mean(), 8.0);
  EXPECT_DOUBLE_EQ(cost.seldom_exceeded(), 8.0 + 4.0 * 4.0);
  cost.add(16.0);
  EXPECT_DOUBLE_EQ(cost.mean(), 9.0);
  EXPECT_DOUBLE_EQ(cost.seldom_exceeded(), 9.0 + 4.0 * (0.75 * 4.0 + 0.25 * 8.0));
}

TEST(FrameBudget, BeginsWithoutKnowingAnything) {
  const FrameBudget budget;
  EXPECT_EQ(budget.first_batch(frame_time), FrameBudget::first_of_all);
  EXPECT_EQ(budget.next_batch(frame_time), 0U);
}

TEST(FrameBudget, FramesAreInTimeAndTheirTimeIsUsed) {
  FrameBudget budget;
  Machine machine;
  constexpr int frames = 10000;
  int late = 0;
  double samples = 0.0;
  for (int i = 0; i < frames; ++i) {
    const Frame frame = run_frame(budget, machine);
    late += frame.took > frame_time ? 1 : 0;
    samples += static_cast<double>(frame.samples);
  }
  EXPECT_LE(late, frames / 100);
  const double possible = (seconds(frame_time) - machine.rest_s) / machine.sample_s;
  EXPECT_GE(samples / frames, 0.8 * possible);
}

/// Where a frame has time for so few samples that they are not many batches.
TEST(FrameBudget, SlowScenesUseTheirTimeToo) {
  for (const double samples_in_a_frame : {500.0, 1000.0, 2000.0, 4000.0}) {
    FrameBudget budget;
    Machine machine;
    const double time_s = seconds(frame_time) - machine.rest_s;
    machine.sample_s = time_s / samples_in_a_frame;
    machine.batch_s = 5e-5;
    for (int i = 0; i < 100; ++i) {
      run_frame(budget, machine);
    }
    constexpr int frames = 5000;
    int late = 0;
    double tracing_s = 0.0;
    for (int i = 0; i < frames; ++i) {
      const Frame frame = run_frame(budget, machine);
      late += frame.took > frame_time ? 1 : 0;
      tracing_s += seconds(frame.tracing);
    }
    EXPECT_LE(late, frames / 200) << samples_in_a_frame;
    EXPECT_GE(tracing_s / frames, 0.9 * time_s) << samples_in_a_frame;
  }
}

TEST(FrameBudget, KeepsAReserveWhereTheMachineIsDisturbed) {
  FrameBudget budget;
  Machine machine;
  machine.variation = 0.01;
  machine.disturbed_share = 0.1;
  constexpr int frames = 10000;
  int late = 0;
  for (int i = 0; i < frames; ++i) {
    late += run_frame(budget, machine).took > frame_time ? 1 : 0;
  }
  EXPECT_LE(late, frames / 100);
  EXPECT_GE(late, frames / 1000) << "else time is wasted";
}

TEST(FrameBudget, LearnsThatAllTakesLonger) {
  FrameBudget budget;
  Machine machine;
  for (int i = 0; i < 100; ++i) {
    run_frame(budget, machine);
  }
  machine.sample_s *= 3.0;  // from the sky into a wood
  EXPECT_GT(run_frame(budget, machine).took, frame_time);
  int late = 0;
  for (int i = 0; i < 20; ++i) {
    late += run_frame(budget, machine).took > frame_time ? 1 : 0;
  }
  EXPECT_LE(late, 1);
}

TEST(FrameBudget, LateFramesStillTraceSomething) {
  FrameBudget budget;
  Machine machine;
  machine.rest_s = 2.0 * seconds(frame_time);
  for (int i = 0; i < 10; ++i) {
    EXPECT_GE(run_frame(budget, machine).samples, 400U) << "a millisecond's, of 500";
  }
  machine.sample_s = 1e-4;
  run_frame(budget, machine);
  run_frame(budget, machine);
  EXPECT_GE(run_frame(budget, machine).samples, 64U) << "even if a millisecond has time for ten";
}

/// As LiveFrames does: a frame ends with a refresh, at which the next one begins.
struct ShownFrame {
  int refreshes = 0;
  Nanoseconds tracing{0};
};

ShownFrame show_frame(FrameBudget& budget, Machine& machine) {
  ShownFrame frame;
  const Nanoseconds left = budget.begin_frame(frame_time, frame_time);
  std::uint64_t samples = budget.first_batch(left);
  for (int batch = 0; batch < 3 && samples > 0; ++batch) {
    const Nanoseconds time = machine.take(machine.sample_s * static_cast<double>(samples));
    budget.batch_took(samples, time);
    frame.tracing += time;
    samples = budget.next_batch(left - frame.tracing);
  }
  const Nanoseconds rest = machine.take(machine.rest_s);
  budget.rest_took(rest);
  const Nanoseconds took = frame.tracing + rest + machine.disturbance();
  frame.refreshes = static_cast<int>((took + frame_time - Nanoseconds(1)) / frame_time);
  budget.frame_ended(frame.refreshes > 1);
  return frame;
}

void show_frames(int frames, FrameBudget& budget, Machine& machine) {
  for (int i = 0; i < frames; ++i) {
    show_frame(budget, machine);
  }
}

// The time for tracing was a millisecond a frame, whatever a frame took.
TEST(FrameBudget, HalfOfTheFrameIsForTracingWhereDrawingIsTooSlow) {
  for (const double rest_in_refreshes : {1.0, 1.2, 2.0, 2.3, 5.0}) {
    for (const double variation : {0.0, 0.1, 0.4}) {
      FrameBudget budget;
      Machine machine;
      machine.rest_s = rest_in_refreshes * seconds(frame_time);
      machine.variation = variation;
      show_frames(200, budget, machine);
      EXPECT_TRUE(budget.is_drawing_too_slow());
      constexpr int frames = 2000;
      int refreshes = 0;
      double tracing_s = 0.0;
      for (int i = 0; i < frames; ++i) {
        const ShownFrame frame = show_frame(budget, machine);
        refreshes += frame.refreshes;
        tracing_s += seconds(frame.tracing);
      }
      const double share = tracing_s / (refreshes * seconds(frame_time));
      EXPECT_GE(share, 0.5) << rest_in_refreshes << ", " << variation;
      EXPECT_LE(share, 0.75) << "the picture is to follow the eye, too";
    }
  }
}

TEST(FrameBudget, AnotherPreviewKnowsThatDrawingIsTooSlowButNotWhatSamplesCost) {
  FrameBudget budget;
  Machine machine;
  machine.rest_s = 0.04;
  show_frames(100, budget, machine);
  FrameBudget next = budget.for_another_preview();
  EXPECT_GT(next.begin_frame(frame_time, frame_time), frame_time);
  EXPECT_EQ(next.first_batch(frame_time), FrameBudget::first_of_all);
}

TEST(FrameBudget, AnotherPreviewBeginsAsTheFirstWhereDrawingIsFast) {
  FrameBudget budget;
  Machine machine;
  show_frames(100, budget, machine);
  FrameBudget next = budget.for_another_preview();
  EXPECT_EQ(next.begin_frame(frame_time, frame_time), frame_time);
  EXPECT_EQ(next.first_batch(frame_time), FrameBudget::first_of_all);
  EXPECT_EQ(next.drawing_time(), Nanoseconds(0));
}

TEST(FrameBudget, FramesThatAreSometimesLateAimAtTheirDeadline) {
  FrameBudget budget;
  Machine machine;
  machine.disturbed_share = 0.3;
  machine.longest_disturbance_s = 0.1;
  for (int i = 0; i < 10000; ++i) {
    show_frame(budget, machine);
    ASSERT_FALSE(budget.is_drawing_too_slow()) << i;
    ASSERT_EQ(budget.begin_frame(frame_time, frame_time), frame_time);
  }
}

TEST(FrameBudget, AFewSlowFramesAreNoSlowDrawing) {
  FrameBudget budget;
  Machine machine;
  for (int pause = 0; pause < 20; ++pause) {
    machine.rest_s = 0.1;
    show_frames(10, budget, machine);
    EXPECT_FALSE(budget.is_drawing_too_slow());
    machine.rest_s = 3e-3;
    show_frames(60, budget, machine);
  }
}

TEST(FrameBudget, AimsAtTheDeadlineAgainOnceDrawingIsFast) {
  FrameBudget budget;
  Machine machine;
  machine.rest_s = 0.04;
  show_frames(100, budget, machine);
  ASSERT_TRUE(budget.is_drawing_too_slow());
  machine.rest_s = 3e-3;  // the window was made smaller
  show_frames(60, budget, machine);
  EXPECT_FALSE(budget.is_drawing_too_slow());
  int late = 0;
  for (int i = 0; i < 1000; ++i) {
    late += show_frame(budget, machine).refreshes > 1 ? 1 : 0;
  }
  EXPECT_LE(late, 10);
}

TEST(FrameBudget, DoesNotWaverWhereDrawingIsNearlyTooSlow) {
  FrameBudget budget;
  Machine machine;
  machine.rest_s = 1.0 * seconds(frame_time);
  show_frames(100, budget, machine);
  ASSERT_TRUE(budget.is_drawing_too_slow());
  machine.rest_s = 0.85 * seconds(frame_time);
  for (int i = 0; i < 1000; ++i) {
    show_frame(budget, machine);
    ASSERT_TRUE(budget.is_drawing_too_slow()) << i;
  }
}

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
