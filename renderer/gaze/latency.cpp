#include "renderer/gaze/latency.h"

#include <cassert>

namespace foveola {
namespace {

LatencyStage steady(std::string_view name, const KnownDuration& duration) {
  return {.name = name,
          .best_s = duration.duration_s,
          .worst_s = duration.duration_s,
          .provenance = duration.provenance};
}

}  // namespace

std::array<LatencyStage, 8> latency_stages(const LatencyInputs& inputs) {
  assert(inputs.tracker_rate_hz > 0.0);
  const double half_exposure_s = 0.5 * inputs.exposure.duration_s;
  return {{LatencyStage{.name = "exposure",
                        .best_s = half_exposure_s,
                        .worst_s = half_exposure_s + 1.0 / inputs.tracker_rate_hz,
                        .provenance = inputs.exposure.provenance},
           steady("transfer", inputs.transfer), steady("processing", inputs.processing),
           LatencyStage{.name = "waiting for the frame",
                        .best_s = 0.0,
                        .worst_s = inputs.frame_interval.duration_s,
                        .provenance = inputs.frame_interval.provenance},
           steady("tracing", inputs.tracing), steady("film and resample", inputs.film_and_resample),
           steady("present", inputs.present), steady("scan-out", inputs.scan_out)}};
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

}  // namespace foveola
