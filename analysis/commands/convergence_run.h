// Measuring convergence gaze after gaze in scene after scene: all of it, a part of it, or only what
// it needs of references.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/convergence/measurement.h"
#include "renderer/base/scene_source.h"
#include "renderer/base/shard.h"
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

/// Some of a gaze's repetitions.
struct GazePart {
  std::size_t scene = 0;
  int gaze = 0;
  ItemRange repetitions;
};

/// The repetitions of a shard of a run with so many scenes, gazes in each of them and repetitions
/// of each gaze, in this order.
std::vector<GazePart> gaze_parts(const Shard& shard, std::size_t scenes, int gazes,
                                 int repetitions);

struct MeasuredPart {
  std::string scene_key;  ///< see Subject::key
  GazeMeasurement measurement;
};

/// What the shard has of a run without a limit, in the order of gaze_parts(). Renders only the
/// references that it needs. Of no use when stopped. Throws Error as measure_all.
std::vector<MeasuredPart> measure_part(const ConvergenceRun& run, const Shard& shard,
                                       const std::stop_token& stop);

/// Renders what the cache lacks of the shard's halves of references. Returns how many halves the
/// shard has. Throws Error as measure_all, and if stopped.
std::int64_t render_references(const ConvergenceRun& run, const Shard& shard,
                               const std::stop_token& stop);

}  // namespace foveola::analysis
