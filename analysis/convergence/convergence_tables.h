// Derives results of a measurement of convergence: speed-ups, costs, slopes and efficiencies.
#pragma once

#include <array>
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

/// A method compared with the baseline, the first configuration. Intervals are over repetitions, by
/// the jackknife. Empty: the error was not reached.
struct SpeedUp {
  std::string scene;
  std::string gaze;
  std::string configuration;
  std::string region;
  Metric metric = Metric::mse;
  Level level = Level::all;
  std::optional<Estimate> samples_ratio;  ///< baseline's samples / this method's, at equal error
  std::optional<Estimate> time_ratio;     ///< baseline's seconds / this method's, at equal error
  /// Predicted from the densities of the samples alone: baseline's MSE / this method's, at equal
  /// samples. Empty for other metrics.
  std::optional<double> predicted;
};

/// Cost of a path, over a render's whole length.
struct PathCost {
  std::string scene;
  std::string gaze;
  std::string configuration;
  std::optional<Estimate> ns_per_path;  ///< nanoseconds, with all threads
  std::optional<Estimate> ratio;        ///< relative to the baseline's
};

/// Convergence rates of the root mean squared error (RMSE), and the efficiency 1 / (mean squared
/// error x seconds) at the end of a render.
struct Convergence {
  std::string scene;
  std::string gaze;
  std::string configuration;
  std::string region;
  /// Slope of log RMSE over log samples; -0.5 for independent noise.
  std::optional<Estimate> slope_in_samples;
  std::optional<Estimate> slope_in_time;
  std::optional<Estimate> efficiency;
  std::optional<Estimate> efficiency_ratio;  ///< relative to the baseline's
};

struct ConvergenceTables {
  std::vector<SpeedUp> speed_ups;  ///< one per configuration except the baseline
  std::vector<PathCost> costs;
  std::vector<Convergence> convergence;
  /// Geometric means over all scenes and gazes, with intervals over these (Student's t). `scene`
  /// and `gaze` are empty.
  std::vector<SpeedUp> overall;
};

/// Returns the tables of all measurements. Each must have a repetition, and all the same
/// configurations and regions in one order; otherwise behaviour is undefined.
ConvergenceTables tabulate(const std::vector<GazeMeasurement>& measurements);

}  // namespace foveola::analysis
