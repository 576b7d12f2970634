#include "renderer/gaze/latency.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace foveola {
namespace {

/// The published system: frames of 14 ms, 10 of them for tracing.
LatencyInputs published() {
  return {.tracker_rate_hz = 120.0,
          .exposure = {.duration_s = 0.008},
          .transfer = {.duration_s = 0.002},
          .processing = {.duration_s = 0.004},
          .frame_interval = {.duration_s = 0.014},
          .tracing = {.duration_s = 0.010},
          .film_and_resample = {.duration_s = 0.003},
          .present = {.duration_s = 0.001},
          .scan_out = {.duration_s = 0.014}};
}

// Koskela et al. 2018, figure 7: 4 + 2 + 4 + 14 + 14 ms.
TEST(Latency, ThePublishedBestCase) {
  EXPECT_NEAR(total_latency(latency_stages(published())).best_s, 0.038, 1e-15);
}

// A tracker period, 8.333 ms, and a frame, 14 ms, more.
TEST(Latency, TheWorstCaseJustMissesAnExposureAndAFrame) {
  EXPECT_NEAR(total_latency(latency_stages(published())).worst_s, 0.038 + 1.0 / 120.0 + 0.014,
              1e-15);
}

TEST(Latency, StagesAreInTheOrderOfTime) {
  const auto stages = latency_stages(published());
  const char* const names[] = {
      "exposure", "transfer",          "processing", "waiting for the frame",
      "tracing",  "film and resample", "present",    "scan-out"};
  const double best_ms[] = {4.0, 2.0, 4.0, 0.0, 10.0, 3.0, 1.0, 14.0};
  for (std::size_t i = 0; i < stages.size(); ++i) {
    EXPECT_EQ(stages[i].name, names[i]);
    EXPECT_NEAR(1e3 * stages[i].best_s, best_ms[i], 1e-12);
    EXPECT_LE(stages[i].best_s, stages[i].worst_s);
  }
}

TEST(Latency, EachStageSaysHowItIsKnown) {
  LatencyInputs inputs = published();
  inputs.tracing.provenance = Provenance::measured;
  const auto stages = latency_stages(inputs);
  EXPECT_EQ(stages[4].provenance, Provenance::measured);
  EXPECT_EQ(stages[5].provenance, Provenance::assumed);
}

TEST(Latency, ATotalIsMeasuredOnlyIfAllOfItIs) {
  const LatencyStage measured{.best_s = 1.0, .worst_s = 2.0, .provenance = Provenance::measured};
  const LatencyStage assumed{.best_s = 1.0, .worst_s = 2.0};
  EXPECT_EQ(total_latency(std::array{measured, measured}).provenance, Provenance::measured);
  EXPECT_EQ(total_latency(std::array{measured, assumed}).provenance, Provenance::assumed);
}

// Of a certain frame it is known how long the gaze had been there.
TEST(Latency, WaitingIsWhatItWasWhereThatIsKnown) {
  LatencyInputs inputs = published();
  inputs.waiting = KnownDuration{.duration_s = 0.003, .provenance = Provenance::measured};
  const LatencyStage waiting = latency_stages(inputs)[3];
  EXPECT_EQ(waiting.best_s, 0.003);
  EXPECT_EQ(waiting.worst_s, 0.003);
  EXPECT_EQ(waiting.provenance, Provenance::measured);
}

TEST(LatencyReport, OfThePublishedFrameIsThePublishedBudget) {
  const std::vector<LatencyStages> frames{latency_stages(published())};
  const LatencyReport report = latency_report(frames);
  EXPECT_NEAR(report.total.best_s, 0.038, 1e-15);
  EXPECT_NEAR(report.total.worst_s, 0.038 + 1.0 / 120.0 + 0.014, 1e-15);
  EXPECT_EQ(report.stages.front().name, "exposure");
  EXPECT_EQ(report.total.name, "total");
}

// An eye moves at any moment of the tracker's period of 8.333 ms.
TEST(LatencyReport, MomentsBetweenBestAndWorstAreEquallyLikely) {
  const std::vector<LatencyStages> frames(100, latency_stages(published()));
  const LatencySpread exposure = latency_report(frames).stages[0];
  const double period_s = 1.0 / 120.0;
  EXPECT_NEAR(exposure.best_s, 0.004, 1e-15);
  EXPECT_NEAR(exposure.median_s, 0.004 + 0.5 * period_s, 0.05 * period_s);
  EXPECT_NEAR(exposure.percentile_95_s, 0.004 + 0.95 * period_s, 0.05 * period_s);
  EXPECT_NEAR(exposure.worst_s, 0.004 + period_s, 1e-15);
}

/// 200 frames whose tracing takes 1, 2, ... 200 ms.
std::vector<LatencyStages> slower_and_slower(LatencyInputs inputs) {
  std::vector<LatencyStages> frames;
  for (int i = 1; i <= 200; ++i) {
    inputs.tracing.duration_s = 1e-3 * i;
    inputs.waiting = KnownDuration{.provenance = Provenance::measured};
    frames.push_back(latency_stages(inputs));
  }
  return frames;
}

TEST(LatencyReport, SpreadsOverFrames) {
  const LatencyReport report = latency_report(slower_and_slower(published()));
  const LatencySpread tracing = report.stages[4];
  EXPECT_EQ(tracing.name, "tracing");
  EXPECT_NEAR(tracing.best_s, 0.001, 1e-15);
  EXPECT_NEAR(tracing.median_s, 0.100, 1e-15);
  EXPECT_NEAR(tracing.percentile_95_s, 0.190, 1e-15);
  EXPECT_NEAR(tracing.worst_s, 0.200, 1e-15);
  // Beside tracing: 4 + 2 + 4 + 3 + 1 + 14 ms, and up to a period more, half of it in the middle.
  EXPECT_NEAR(report.total.best_s, 0.028 + 0.001, 1e-12);
  EXPECT_NEAR(report.total.median_s, 0.028 + 0.1005 + 0.5 / 120.0, 5e-4);
  EXPECT_NEAR(report.total.worst_s, 0.028 + 0.200 + 1.0 / 120.0, 1e-12);
}

TEST(LatencyReport, AStageIsMeasuredOnlyIfItIsInEveryFrame) {
  LatencyInputs inputs = published();
  inputs.tracing.provenance = Provenance::measured;
  std::vector<LatencyStages> frames = slower_and_slower(inputs);
  EXPECT_EQ(latency_report(frames).stages[4].provenance, Provenance::measured);
  EXPECT_EQ(latency_report(frames).total.provenance, Provenance::assumed);
  frames[7][4].provenance = Provenance::assumed;
  EXPECT_EQ(latency_report(frames).stages[4].provenance, Provenance::assumed);
}

}  // namespace
}  // namespace foveola
