#include "renderer/gaze/latency.h"

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

}  // namespace
}  // namespace foveola
