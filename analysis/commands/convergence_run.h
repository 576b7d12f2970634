// Measures convergence at several gazes in several scenes, or renders the references alone.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "analysis/convergence/measurement.h"
#include "renderer/base/scene_source.h"
#include "renderer/base/work/shard.h"
#include "renderer/image/image.h"

namespace foveola::analysis {

struct ConvergenceRun {
  ConvergencePlan plan;
  std::vector<SceneSource> scenes;
  int gazes = 1;         ///< around the horizon, the first ahead of the scene's camera
  int threads = 0;       ///< 0: one per core
  double limit_s = 0.0;  ///< total time limit; 0: none
};

struct MeasuredGazes {
  std::vector<GazeMeasurement> measurements;
  std::vector<RgbImage> crops;  ///< one strip per measurement
  std::vector<double> exposure_stops;
};

/// Measures all gazes, each for its share of the remaining time. When stopped, returns the finished
/// measurements. Throws Error for a scene that cannot be loaded, and as reference_image unless
/// stopped.
MeasuredGazes measure_all(const ConvergenceRun& run, const std::stop_token& stop);

/// Renders the shard's halves of references that the cache lacks. Returns the number of the shard's
/// halves. Throws Error as measure_all, and if stopped.
std::int64_t render_references(const ConvergenceRun& run, const Shard& shard,
                               const std::stop_token& stop);

}  // namespace foveola::analysis
