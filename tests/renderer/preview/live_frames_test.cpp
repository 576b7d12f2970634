#include "renderer/preview/live_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "tests/renderer/preview/box_room.h"

namespace foveola {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr double refresh_rate_hz = 100.0;
constexpr Nanoseconds refresh_interval = milliseconds(10);

/// A machine on which a sample takes so long and a presentation so long, and nothing else anything.
class ModelClock final : public Clock {
 public:
  explicit ModelClock(const Preview& preview) : preview_(&preview) {}

  Nanoseconds now() const override {
    const std::uint64_t samples = preview_->film().total_samples();
    if (samples < seen_samples_) {
      seen_samples_ = 0;  // the film was cleared
    }
    now_ += sample_time_ * (samples - seen_samples_);
    seen_samples_ = samples;
    return now_;
  }

  void set_sample_time(Nanoseconds time) { sample_time_ = time; }
  void advance(Nanoseconds time) { now_ += time; }
  void advance_to(Nanoseconds time) { now_ = std::max(now(), time); }

 private:
  const Preview* preview_;
  Nanoseconds sample_time_ = microseconds(1);
  mutable Nanoseconds now_{0};
  mutable std::uint64_t seen_samples_ = 0;
};

class LiveFramesTest : public testing::Test {
 protected:
  LiveFramesTest() { preview_.restart("od", 1); }

  static PreviewSettings small_settings() {
    PreviewSettings settings;
    settings.render.film_size = {128, 64};
    settings.render.trace.max_depth = 1;
    return settings;
  }

  /// present: what it does with the image; every frame is resampled in 0.7 ms, or somewhat longer.
  LiveFrames frames(std::function<std::optional<Nanoseconds>()> present) {
    return {preview_,
            clock_,
            RefreshEstimator(refresh_rate_hz),
            [&](Nanoseconds time) { clock_.advance_to(time); },
            {.resample =
                 [&](const Preview&) {
                   const double longer_s = delays_.uniform() * seconds(resampling_varies_by_);
                   clock_.advance(microseconds(700) + nanoseconds_from_seconds(longer_s));
                 },
             .present = std::move(present)}};
  }

  /// Presents in 0.3 ms, and knows of no refresh.
  LiveFrames frames() {
    return frames([&] {
      clock_.advance(microseconds(300));
      return std::nullopt;
    });
  }

  static void skip(LiveFrames& live, int frames) {
    for (int i = 0; i < frames; ++i) {
      live.next();
    }
  }

  Scene scene_ = box_room(0.2F);
  Workers workers_{2};
  PathTracer tracer_{scene_, workers_};
  FixedEyeTracker ahead_{Vec3(0.0F, 0.0F, -1.0F)};
  ScriptedHeadTracker still_{{{.time = Nanoseconds(0), .heading = {}}}};
  Preview preview_{tracer_, small_settings(), ahead_, still_, workers_};
  ModelClock clock_{preview_};
  Nanoseconds resampling_varies_by_{0};
  Pcg32 delays_{3};
};

TEST_F(LiveFramesTest, BeginAtRefreshesAndUseTheirTime) {
  LiveFrames live = frames();
  LiveFrame frame;
  for (int i = 0; i < 60; ++i) {
    frame = live.next();
    EXPECT_EQ(frame.start, i * refresh_interval);
    EXPECT_EQ(frame.deadline, (i + 1) * refresh_interval);
    EXPECT_EQ(frame.report.time, frame.start);
    EXPECT_FALSE(frame.is_late());
  }
  EXPECT_EQ(frame.resampling, microseconds(700));
  EXPECT_EQ(frame.presenting, microseconds(300));
  EXPECT_EQ(frame.shown, frame.deadline);
  EXPECT_FALSE(frame.is_refresh_measured);
  EXPECT_EQ(frame.tracing, microseconds(frame.report.samples));
  EXPECT_GT(frame.report.samples, 8500U) << "of 9000, now that it is known what they take";
}

TEST_F(LiveFramesTest, LateOnesAreReportedAndTheNextIsOnTime) {
  LiveFrames live = frames();
  for (int i = 0; i < 60; ++i) {
    live.next();
  }
  clock_.set_sample_time(microseconds(4));
  const LiveFrame late = live.next();
  EXPECT_TRUE(late.is_late());
  const Nanoseconds over = late.tracing + milliseconds(1) - refresh_interval;
  EXPECT_EQ(
      late.missed_refreshes,
      static_cast<std::uint64_t>((over + refresh_interval - Nanoseconds(1)) / refresh_interval));
  EXPECT_EQ(late.shown, late.deadline + refresh_interval * late.missed_refreshes);
  const LiveFrame next = live.next();
  EXPECT_EQ(next.start, late.deadline + refresh_interval * late.missed_refreshes);
  EXPECT_FALSE(next.is_late());
}

// It refreshes a little more slowly than its profile says, and not when frames begin. A swap waits
// for that, and is heard of up to a millisecond later.
class WaitingDisplay {
 public:
  explicit WaitingDisplay(ModelClock& clock) : clock_(&clock) {}

  static constexpr Nanoseconds interval{10'020'000};
  static constexpr Nanoseconds first_refresh{3'700'000};

  Nanoseconds swap() {
    const Nanoseconds since_first = clock_->now() - first_refresh;
    const auto refreshes =
        static_cast<std::int64_t>(std::ceil(seconds(since_first) / seconds(interval)));
    clock_->advance_to(first_refresh + refreshes * interval +
                       nanoseconds_from_seconds(1e-3 * random_.uniform()));
    return clock_->now();
  }

  /// How far `time` is behind the refresh nearest to it.
  static double behind_refresh_ms(Nanoseconds time) {
    return 1e3 * std::remainder(seconds(time - first_refresh), seconds(interval));
  }

 private:
  ModelClock* clock_;
  Pcg32 random_{4};
};

TEST_F(LiveFramesTest, FollowADisplayThatSwapsWaitFor) {
  clock_.set_sample_time(Nanoseconds(1500));
  WaitingDisplay display(clock_);
  LiveFrames live = frames([&] { return display.swap(); });
  skip(live, 150);
  constexpr int frames_watched = 150;
  int late = 0;
  std::uint64_t samples = 0;
  for (int i = 0; i < frames_watched; ++i) {
    const LiveFrame frame = live.next();
    ASSERT_TRUE(frame.is_refresh_measured);
    // Swaps are heard of half a millisecond late on average.
    ASSERT_NEAR(WaitingDisplay::behind_refresh_ms(frame.deadline), 0.5, 0.2);
    ASSERT_NEAR(WaitingDisplay::behind_refresh_ms(frame.shown), 0.5, 0.2);
    samples += frame.report.samples;
    late += frame.is_late() ? 1 : 0;
  }
  EXPECT_LE(late, 3);
  // A frame has 10 ms, less 0.7 for resampling, and begins up to 0.5 late.
  constexpr std::uint64_t possible = 5900;
  EXPECT_GE(samples, frames_watched * possible * 8 / 10) << "the wait for a swap is no work";
  EXPECT_NEAR(live.refresh().rate_hz(), 1.0 / seconds(WaitingDisplay::interval), 0.05);
}

TEST_F(LiveFramesTest, ARefreshThatIsMissedIsSeenInTheSwap) {
  clock_.set_sample_time(Nanoseconds(1500));
  WaitingDisplay display(clock_);
  LiveFrames live = frames([&] { return display.swap(); });
  skip(live, 150);
  clock_.set_sample_time(microseconds(6));
  const LiveFrame late = live.next();
  const Nanoseconds over = late.start + late.tracing + late.resampling - late.deadline;
  EXPECT_EQ(late.missed_refreshes, static_cast<std::uint64_t>(over / WaitingDisplay::interval + 1));
  EXPECT_NEAR(WaitingDisplay::behind_refresh_ms(late.shown), 0.5, 0.2);
}

// What does not wait is done when the frame is: earlier than the refresh that the frame aims at.
TEST_F(LiveFramesTest, KeepTheNominalRateWhereSwapsDoNotWait) {
  clock_.set_sample_time(microseconds(8));
  // Frames whose costs never vary are ready just in time, as if they had waited.
  resampling_varies_by_ = microseconds(600);
  LiveFrames live = frames([&] {
    clock_.advance(microseconds(300));
    return clock_.now();
  });
  skip(live, 1000);
  EXPECT_TRUE(live.refresh().is_unsynchronised());
  const LiveFrame frame = live.next();
  EXPECT_FALSE(frame.is_refresh_measured);
  EXPECT_EQ(live.next().start - frame.start, refresh_interval);
}

TEST_F(LiveFramesTest, LeaveTheProcessorToOthersWhileTheyGiveWay) {
  LiveFrames live = frames();
  skip(live, 60);
  live.give_way(true);
  const LiveFrame first = live.next();
  EXPECT_LE(first.report.samples, 64U);
  EXPECT_EQ(live.next().start - first.start, 3 * refresh_interval);
  live.give_way(false);
  live.next();
  const LiveFrame usual = live.next();
  EXPECT_GT(usual.report.samples, 8500U);
  EXPECT_FALSE(usual.is_late());
}

// As in software: the picture alone takes the time of four refreshes.
TEST_F(LiveFramesTest, HalfOfTheFrameIsForTracingWhereDrawingIsTooSlow) {
  LiveFrames live = frames([&] {
    clock_.advance(milliseconds(37));
    return std::nullopt;
  });
  EXPECT_FALSE(live.too_slow_drawing());
  skip(live, 100);
  ASSERT_TRUE(live.too_slow_drawing());
  EXPECT_NEAR(seconds(*live.too_slow_drawing()), 37.7e-3, 1e-4);
  const LiveFrame first = live.next();
  Nanoseconds tracing = first.tracing;
  Nanoseconds shown = first.shown;
  constexpr int frames_watched = 100;
  for (int i = 1; i < frames_watched; ++i) {
    const LiveFrame frame = live.next();
    EXPECT_TRUE(frame.is_late());
    EXPECT_EQ(frame.start, shown) << "nothing waits for a refresh that nobody knows of";
    EXPECT_NEAR(seconds(frame.shown - frame.deadline) / seconds(refresh_interval),
                static_cast<double>(frame.missed_refreshes), 0.5);
    tracing += frame.tracing;
    shown = frame.shown;
  }
  EXPECT_GE(seconds(tracing) / seconds(shown - first.start), 0.5);
}

TEST_F(LiveFramesTest, ARestartIsSeenInTheNextFrame) {
  LiveFrames live = frames();
  for (int i = 0; i < 5; ++i) {
    live.next();
  }
  preview_.restart("fv", 2);
  const LiveFrame frame = live.next();
  EXPECT_EQ(frame.report.frame, 0U);
  EXPECT_GE(frame.report.samples, 64U);
  EXPECT_EQ(preview_.film().total_samples(), frame.report.samples);
}

using std::chrono::microseconds;
using std::chrono::milliseconds;

/// FOVE 0, by the published account.
TrackerProfile published_tracker() {
  TrackerProfile tracker;
  tracker.rate_hz = 120.0;
  tracker.exposure = {.duration_s = 0.008};
  tracker.transfer = {.duration_s = 0.002, .provenance = Provenance::measured};
  tracker.processing = {.duration_s = 0.004};
  return tracker;
}

DisplayProfile published_display() {
  DisplayProfile display;
  display.scan_out = {.duration_s = 0.014};
  return display;
}

/// A frame of 14 ms whose gaze arrived as it looked: 4 ms of exposure, 2 and 4 ms.
LiveFrame published_frame() {
  LiveFrame frame{.start = milliseconds(5000), .deadline = milliseconds(5014)};
  frame.report.gaze_valid = true;
  frame.report.gaze_age = milliseconds(10);
  frame.polling = microseconds(20);
  frame.tracing = microseconds(9980);
  frame.resampling = milliseconds(3);
  frame.presenting = microseconds(500);
  frame.shown = frame.deadline;
  frame.is_refresh_measured = true;
  return frame;
}

LatencyStages stages_of(const LiveFrame& frame) {
  return frame_latency(frame, published_tracker(), published_display());
}

// Koskela et al. 2018, figure 7: 4 + 2 + 4 + 14 + 14 ms.
TEST(FrameLatency, OfThePublishedFrame) {
  EXPECT_NEAR(total_latency(stages_of(published_frame())).best_s, 0.038, 1e-12);
}

TEST(FrameLatency, IsMadeOfWhatTheFrameTook) {
  LiveFrame frame = published_frame();
  frame.report.gaze_age = milliseconds(13);
  const double best_ms[] = {4.0, 2.0, 4.0, 3.0, 10.0, 3.0, 1.0, 14.0};
  const LatencyStages stages = stages_of(frame);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    EXPECT_NEAR(1e3 * stages[i].best_s, best_ms[i], 1e-9) << stages[i].name;
    const double range_ms = i == 0 ? 1e3 / 120.0 : 0.0;  // the eye may have moved a period before
    EXPECT_NEAR(1e3 * (stages[i].worst_s - stages[i].best_s), range_ms, 1e-9) << stages[i].name;
  }
}

TEST(FrameLatency, ALateFrameWaitsToBePresented) {
  LiveFrame frame = published_frame();
  frame.tracing = milliseconds(12);
  frame.shown = milliseconds(5028);
  EXPECT_NEAR(total_latency(stages_of(frame)).best_s, 0.052, 1e-12) << "a refresh more";
}

TEST(FrameLatency, SaysWhatIsMeasured) {
  const auto is_measured = [](const LiveFrame& frame) {
    std::array<bool, 8> measured{};
    for (std::size_t i = 0; i < measured.size(); ++i) {
      measured[i] = stages_of(frame)[i].provenance == Provenance::measured;
    }
    return measured;
  };
  LiveFrame frame = published_frame();
  EXPECT_EQ(is_measured(frame), (std::array{false, true, false, true, true, true, true, false}));
  frame.is_refresh_measured = false;
  EXPECT_EQ(is_measured(frame), (std::array{false, true, false, true, true, true, false, false}));
}

TEST(FrameLatency, AGazeYoungerThanItsTrackerAllowsHasNotWaited) {
  LiveFrame frame = published_frame();
  frame.report.gaze_age = milliseconds(6);
  EXPECT_EQ(stages_of(frame)[3].best_s, 0.0);
}

TEST(FrameLatency, HeldGazeDoesNotFollowTheEye) {
  EXPECT_TRUE(follows_eye({.gaze_valid = true}));
  EXPECT_FALSE(follows_eye({.gaze_valid = false}));
  EXPECT_FALSE(follows_eye({.gaze_valid = true, .gaze_held = true}));
}

// 8.33 + 4 + 2 + 4 ms.
TEST(FrameLatency, GazeIsAPeriodOldAtMostAndWhatItsTrackerTakes) {
  EXPECT_NEAR(gaze_age_limit_s(published_tracker()), 0.018333333, 1e-8);
}

}  // namespace

}  // namespace foveola
