// Derives results of a measurement of convergence: speed-ups, costs, slopes and efficiencies.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/convergence/error_curve.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// The error at which a method is compared with the baseline: the minimum that both reach with all
/// of their samples, or with a quarter of them, which should give the same.
enum class Level { all, quarter };
inline constexpr std::array levels = {Level::all, Level::quarter};
std::string_view name_of(Level level);

/// Intervals are over repetitions, by the jackknife. Empty: the error was not reached.
struct SpeedUp {
  std::string scene;
  std::string gaze;
  std::string configuration;
  std::string region;
  Metric metric = Metric::mse;
  Level level = Level::all;
  std::optional<Estimate> samples;  ///< the baseline's samples over this method's, at equal error
  std::optional<Estimate> time;     ///< the speed-up in seconds
  std::optional<double> predicted;  ///< predicted by density alone: the speed-up in mean squared
                                    ///< error at equal samples
};

/// Cost of a path, over a render's whole length.
struct PathCost {
  std::string scene;
  std::string gaze;
  std::string configuration;
  std::optional<Estimate> ns_per_path;  ///< nanoseconds, with all threads
  std::optional<Estimate> ratio;        ///< relative to the baseline's
};

/// Root mean squared error, and 1 / (mean squared error x seconds) at a render's end.
struct Convergence {
  std::string scene;
  std::string gaze;
  std::string configuration;
  std::string region;
  std::optional<Estimate>
      slope_in_samples;  ///< slope of the logarithm of RMSE; -0.5 for independent noise
  std::optional<Estimate> slope_in_time;
  std::optional<Estimate> efficiency;
  std::optional<Estimate> efficiency_ratio;  ///< relative to the baseline's
};

struct ConvergenceTables {
  std::vector<SpeedUp> speed_ups;  ///< one per configuration except the baseline
  std::vector<PathCost> costs;
  std::vector<Convergence> convergence;
  /// Geometric means over all scenes and gazes, which are unnamed, with intervals over these
  /// (Student's t).
  std::vector<SpeedUp> overall;
};

/// Every measurement must have at least one repetition, and all the same configurations and
/// regions.
ConvergenceTables tabulate(const std::vector<GazeMeasurement>& measurements);

}  // namespace foveola::analysis
