#include "renderer/gaze/latency.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "renderer/base/numbers/quantile.h"

namespace foveola {
namespace {

LatencyStage steady(std::string_view name, const KnownDuration& duration) {
  return {.name = name,
          .best_s = duration.duration_s,
          .worst_s = duration.duration_s,
          .provenance = duration.provenance};
}

LatencyStage waiting_for_frame(const LatencyInputs& inputs) {
  constexpr std::string_view name = "waiting for the frame";
  return inputs.waiting ? steady(name, *inputs.waiting)
                        : LatencyStage{.name = name,
                                       .best_s = 0.0,
                                       .worst_s = inputs.frame_interval.duration_s,
                                       .provenance = inputs.frame_interval.provenance};
}

/// frames: the same stage of each frame.
LatencySpread spread_over(std::span<const LatencyStage> frames) {
  constexpr int moments = 20;
  LatencySpread spread{.name = frames.front().name,
                       .best_s = frames.front().best_s,
                       .worst_s = frames.front().worst_s,
                       .provenance = Provenance::measured};
  std::vector<double> durations_s;
  durations_s.reserve(frames.size() * moments);
  for (const LatencyStage& stage : frames) {
    spread.best_s = std::min(spread.best_s, stage.best_s);
    spread.worst_s = std::max(spread.worst_s, stage.worst_s);
    if (stage.provenance == Provenance::assumed) {
      spread.provenance = Provenance::assumed;
    }
    for (int moment = 0; moment < moments; ++moment) {
      durations_s.push_back(std::lerp(stage.best_s, stage.worst_s, (moment + 0.5) / moments));
    }
  }
  std::ranges::sort(durations_s);
  spread.median_s = quantile(durations_s, 0.5);
  spread.percentile_95_s = quantile(durations_s, 0.95);
  return spread;
}

}  // namespace

LatencyStages latency_stages(const LatencyInputs& inputs) {
  assert(inputs.tracker_rate_hz > 0.0);
  const double half_exposure_s = 0.5 * inputs.exposure.duration_s;
  return {{LatencyStage{.name = "exposure",
                        .best_s = half_exposure_s,
                        .worst_s = half_exposure_s + 1.0 / inputs.tracker_rate_hz,
                        .provenance = inputs.exposure.provenance},
           steady("transfer", inputs.transfer), steady("processing", inputs.processing),
           waiting_for_frame(inputs), steady("tracing", inputs.tracing),
           steady("film and resample", inputs.film_and_resample), steady("present", inputs.present),
           steady("scan-out", inputs.scan_out)}};
}

LatencyStage total_latency(std::span<const LatencyStage> stages) {
  LatencyStage total{.name = "total", .provenance = Provenance::measured};
  for (const LatencyStage& stage : stages) {
    total.best_s += stage.best_s;
    total.worst_s += stage.worst_s;
    if (stage.provenance == Provenance::assumed) {
      total.provenance = Provenance::assumed;
    }
  }
  return total;
}

LatencyReport latency_report(std::span<const LatencyStages> frames) {
  assert(!frames.empty());
  LatencyReport report;
  std::vector<LatencyStage> of_frames(frames.size());
  for (std::size_t stage = 0; stage < report.stages.size(); ++stage) {
    std::transform(frames.begin(), frames.end(), of_frames.begin(),
                   [&](const LatencyStages& stages) { return stages[stage]; });
    report.stages[stage] = spread_over(of_frames);
  }
  std::transform(frames.begin(), frames.end(), of_frames.begin(),
                 [](const LatencyStages& stages) { return total_latency(stages); });
  report.total = spread_over(of_frames);
  return report;
}

}  // namespace foveola
