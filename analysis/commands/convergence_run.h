// Measures convergence gaze after gaze in scene after scene, or renders the references alone.
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
  int threads = 0;       ///< 0: one for each core
  double limit_s = 0.0;  ///< of everything; 0: none
};

struct MeasuredGazes {
  std::vector<GazeMeasurement> measurements;
  std::vector<RgbImage> crops;  ///< one strip for each measurement
  std::vector<double> exposure_stops;
};

/// Everything, and of the time that is left each gaze's share; what was finished when stopped.
/// Throws Error for a scene that cannot be loaded, and as reference_image unless stopped.
MeasuredGazes measure_all(const ConvergenceRun& run, const std::stop_token& stop);

/// Renders what the cache lacks of the shard's halves of references. Returns how many halves the
/// shard has. Throws Error as measure_all, and if stopped.
std::int64_t render_references(const ConvergenceRun& run, const Shard& shard,
                               const std::stop_token& stop);

}  // namespace foveola::analysis
