#include "renderer/preview/live_frames.h"

#include <gtest/gtest.h>

#include "tests/renderer/preview/box_room.h"

namespace foveola {
namespace {

constexpr double refresh_rate_hz = 100.0;
constexpr Nanoseconds refresh_interval = std::chrono::milliseconds(10);

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
  Nanoseconds sample_time_ = std::chrono::microseconds(1);
  mutable Nanoseconds now_{0};
  mutable std::uint64_t seen_samples_ = 0;
};

class LiveFramesTest : public testing::Test {
 protected:
  LiveFramesTest() { preview_.restart("od", 1); }

  static PreviewSettings small_settings() {
    PreviewSettings settings;
    settings.film_width = 128;
    settings.film_height = 64;
    settings.trace.max_depth = 1;
    return settings;
  }

  LiveFrames frames() {
    return {preview_, clock_, refresh_rate_hz, [&](Nanoseconds time) { clock_.advance_to(time); },
            [&](const Preview&) { clock_.advance(std::chrono::milliseconds(1)); }};
  }

  Scene scene_ = box_room(0.2F);
  Workers workers_{2};
  PathTracer tracer_{scene_, workers_};
  FixedEyeTracker ahead_{Vec3(0.0F, 0.0F, -1.0F)};
  ScriptedHeadTracker still_{{{.time = Nanoseconds(0), .heading = {}}}};
  Preview preview_{tracer_, small_settings(), ahead_, still_, workers_};
  ModelClock clock_{preview_};
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
  EXPECT_EQ(frame.presenting, std::chrono::milliseconds(1));
  EXPECT_EQ(frame.tracing, std::chrono::microseconds(frame.report.samples));
  EXPECT_GT(frame.report.samples, 8500U) << "of 9000, now that it is known what they take";
}

TEST_F(LiveFramesTest, LateOnesAreToldAndTheNextIsOnTime) {
  LiveFrames live = frames();
  for (int i = 0; i < 60; ++i) {
    live.next();
  }
  clock_.set_sample_time(std::chrono::microseconds(4));
  const LiveFrame late = live.next();
  EXPECT_TRUE(late.is_late());
  const Nanoseconds over = late.tracing + late.presenting - refresh_interval;
  EXPECT_EQ(
      late.missed_refreshes,
      static_cast<std::uint64_t>((over + refresh_interval - Nanoseconds(1)) / refresh_interval));
  const LiveFrame next = live.next();
  EXPECT_EQ(next.start, late.deadline + refresh_interval * late.missed_refreshes);
  EXPECT_FALSE(next.is_late());
}

TEST_F(LiveFramesTest, ARestartIsSeenInTheNextFrame) {
  LiveFrames live = frames();
  for (int i = 0; i < 5; ++i) {
    live.next();
  }
  preview_.restart("fv", 2);
  const LiveFrame frame = live.next();
  EXPECT_EQ(frame.report.frame, 0U);
  EXPECT_GE(frame.report.samples, FrameBudget::smallest_batch);
  EXPECT_EQ(preview_.film().total_samples(), frame.report.samples);
}

}  // namespace
}  // namespace foveola
