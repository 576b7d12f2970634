// Curves of error over time, when they reach an error, and jackknife intervals of their ratios.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/convergence/measurement.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

enum class Metric { mse, relative_mse, flip };
inline constexpr std::array metrics = {Metric::mse, Metric::relative_mse, Metric::flip};
std::string_view name_of(Metric metric);

enum class Axis { samples, seconds };

struct CurvePoint {
  double samples = 0.0;
  double seconds = 0.0;
  double error = 0.0;
  double samples_per_pixel = 0.0;  ///< weighted mean over the region
  double empty_share = 0.0;        ///< weight of the region's pixels without samples, of all weight

  double along(Axis axis) const { return axis == Axis::samples ? samples : seconds; }
};

/// Points in the order of their samples.
using ErrorCurve = std::vector<CurvePoint>;

/// Where a curve is taken from: its positions in a GazeMeasurement.
struct CurveSource {
  std::size_t configuration = 0;
  std::size_t region = 0;
  Metric metric = Metric::mse;
};

/// Means over the repetitions `kept`. Only points where an error can be compared: with no fewer
/// than 2 samples per pixel and no more than 2 % of the region empty, for a pixel without samples
/// has no error; and with an error above zero.
ErrorCurve mean_curve(const GazeMeasurement& measurement, const CurveSource& source,
                      std::span<const std::size_t> kept);

/// How far along the axis a curve first falls to `error` (> 0), between its points as a power law.
/// Empty if all of it lies above or below.
std::optional<double> reach(const ErrorCurve& curve, double error, Axis axis);

/// The exponent s of error ~ x^s: least squares over the logarithms. Empty with fewer than three
/// points.
std::optional<double> log_log_slope(const ErrorCurve& curve, Axis axis);

/// A statistic of the repetitions `kept`; empty where it is not defined.
using RepetitionStatistic = std::function<std::optional<double>(std::span<const std::size_t> kept)>;

/// The statistic of all `repetitions` and its 95 % interval from the jackknife: with v_i the value
/// without repetition i, the standard error is sqrt((n - 1) / n sum (v_i - mean v)^2), and
/// Student's t has n - 1 degrees of freedom (Efron and Tibshirani 1993, "An Introduction to the
/// Bootstrap", eq. 11.5 and section 12.5). No interval with fewer than two repetitions or where
/// some v_i is not defined; empty if the statistic is not.
std::optional<Estimate> jackknife(std::size_t repetitions, const RepetitionStatistic& statistic);

/// The jackknife of a ratio (> 0), made on its logarithm.
std::optional<Estimate> jackknife_ratio(std::size_t repetitions, const RepetitionStatistic& ratio);

}  // namespace foveola::analysis
