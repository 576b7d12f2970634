#include "renderer/preview/frame_budget.h"

#include <gtest/gtest.h>

#include "renderer/base/random.h"

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

}  // namespace
}  // namespace foveola
