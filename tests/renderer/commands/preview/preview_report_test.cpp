#include "renderer/commands/preview/preview_report.h"

#include <cstdint>
#include <string>

#include "tests/matchers.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

/// Frames at 100 Hz that trace 1, 2, ... 8 ms, of gaze that is 15, 16, ... 22 ms old: seen for 4
/// ms, and older than 20 in two of them.
PreviewRun eight_frames() {
  PreviewRun run;
  run.tracker.name = "slow";
  run.tracker.rate_hz = 100.0;
  run.tracker.exposure = {.duration_s = 0.008};
  run.tracker.processing = {.duration_s = 0.002, .provenance = Provenance::measured};
  run.display.name = "steady";
  run.display.scan_out = {.duration_s = 0.010};
  run.refresh_rate_hz = 100.0;
  run.threads = 3;
  for (int i = 1; i <= 8; ++i) {
    LiveFrame frame{.start = i * milliseconds(10), .deadline = (i + 1) * milliseconds(10)};
    frame.report.frame = static_cast<std::uint64_t>(i - 1) % 4;
    frame.report.samples = static_cast<std::uint64_t>(1000 * i);
    frame.report.gaze_valid = true;
    frame.report.gaze_age = milliseconds(14 + i);
    frame.tracing = milliseconds(i);
    frame.shown = frame.deadline;
    run.frames.push_back(frame);
  }
  return run;
}

nlohmann::ordered_json row(const nlohmann::ordered_json& rows, const std::string& name) {
  for (const auto& candidate : rows) {
    if (candidate.at("name") == name) {
      return candidate;
    }
  }
  return {};
}

TEST(PreviewReport, SaysWhatFramesTook) {
  PreviewRun run = eight_frames();
  run.frames[3].missed_refreshes = 2;
  const auto json = preview_json(run);
  EXPECT_EQ(json.at("frames"), 8);
  EXPECT_EQ(json.at("late_frames"), 1);
  EXPECT_EQ(json.at("starts"), 2);
  EXPECT_EQ(json.at("starts_seen_in_the_first_frame"), 2);
  const auto tracing = row(json.at("figures"), "tracing");
  EXPECT_NEAR(tracing.at("median").get<double>(), 4.0, 1e-9);
  EXPECT_LE(tracing.at("low"), tracing.at("median"));
  EXPECT_GE(tracing.at("high"), tracing.at("median"));
  EXPECT_NEAR(tracing.at("percentile_99").get<double>(), 8.0, 1e-9);
  EXPECT_NEAR(tracing.at("largest").get<double>(), 8.0, 1e-9);
  EXPECT_EQ(row(json.at("figures"), "samples").at("median"), 4000.0);
}

TEST(PreviewReport, SaysHowLongItTookFromTheEyeToLight) {
  const auto json = preview_json(eight_frames());
  EXPECT_EQ(json.at("frames_that_follow_the_eye"), 8);
  const auto rows = json.at("latency");
  ASSERT_EQ(rows.size(), 9U);
  const auto waiting = row(rows, "waiting for the frame");
  EXPECT_NEAR(waiting.at("best_ms").at("value").get<double>(), 9.0, 1e-9);
  EXPECT_NEAR(waiting.at("median_ms").at("value").get<double>(), 12.0, 1e-9);
  EXPECT_NEAR(waiting.at("worst_ms").at("value").get<double>(), 16.0, 1e-9);
  EXPECT_EQ(waiting.at("provenance"), "measured");
  const auto present = row(rows, "present");
  EXPECT_NEAR(present.at("best_ms").at("value").get<double>(), 2.0, 1e-9)
      << "of 10, of which 8 were traced";
  EXPECT_EQ(present.at("provenance"), "assumed");
  // The gaze's age, a frame of 10 ms, 10 ms of scan-out, and a period of the tracker at worst.
  const auto total = row(rows, "total");
  EXPECT_NEAR(total.at("best_ms").at("value").get<double>(), 15.0 + 20.0, 1e-9);
  EXPECT_NEAR(total.at("worst_ms").at("value").get<double>(), 22.0 + 20.0 + 10.0, 1e-9);
}

TEST(PreviewReport, SaysHowOftenTheGazeWasFresh) {
  const auto json = preview_json(eight_frames());
  EXPECT_NEAR(json.at("gaze_age_limit_ms").get<double>(), 16.0, 1e-9);
  EXPECT_EQ(json.at("frames_with_gaze_within_it"), 2);
}

TEST(PreviewReport, LeavesOutFramesThatDoNotFollowTheEye) {
  PreviewRun run = eight_frames();
  run.frames[0].report.gaze_valid = false;
  run.frames[7].report.gaze_held = true;
  const auto json = preview_json(run);
  EXPECT_EQ(json.at("frames_that_follow_the_eye"), 6);
  EXPECT_EQ(json.at("frames_with_gaze_within_it"), 1);
  EXPECT_NEAR(row(json.at("latency"), "total").at("best_ms").at("value").get<double>(), 36.0, 1e-9);
}

TEST(PreviewReport, MayHaveNoFrameThatFollowsTheEye) {
  PreviewRun run = eight_frames();
  for (LiveFrame& frame : run.frames) {
    frame.report.gaze_valid = false;
  }
  EXPECT_TRUE(preview_json(run).at("latency").empty());
  EXPECT_THAT(preview_text(run), HasSubstr("in the 0 frames that follow it"));
}

}  // namespace
}  // namespace foveola
