// Curves of error over time: crossings of an error, slopes, and jackknife intervals of ratios.
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
  double empty_share =
      0.0;  ///< weight of the region's pixels without samples, as a fraction of its weight

  double along(Axis axis) const { return axis == Axis::samples ? samples : seconds; }
};

/// Points in the order of their samples.
using ErrorCurve = std::vector<CurvePoint>;

/// The curve's positions in a GazeMeasurement.
struct CurveSource {
  std::size_t configuration = 0;
  std::size_t region = 0;
  Metric metric = Metric::mse;
};

/// Returns means over the repetitions `kept`, at points with comparable errors: above zero, with at
/// least 2 samples per pixel and at most 2 % of the region empty, because pixels without samples
/// have no error.
ErrorCurve mean_curve(const GazeMeasurement& measurement, const CurveSource& source,
                      std::span<const std::size_t> kept);

/// Returns the position on the axis at which a curve first falls to `error` (> 0), interpolated as
/// a power law. Empty if it never does, or begins below.
std::optional<double> reach(const ErrorCurve& curve, double error, Axis axis);

/// Returns the exponent s of error ~ x^s, by least squares of the logarithms. Empty with fewer than
/// three points.
std::optional<double> log_log_slope(const ErrorCurve& curve, Axis axis);

/// A statistic of the repetitions `kept`; empty if it is not defined.
using RepetitionStatistic = std::function<std::optional<double>(std::span<const std::size_t> kept)>;

/// Returns the statistic of all `repetitions` and its 95 % confidence interval by the jackknife.
/// With v_i the value without repetition i, the standard error is sqrt((n - 1) / n sum (v_i - mean
/// v)^2), and Student's t has n - 1 degrees of freedom (Efron and Tibshirani 1993, "An Introduction
/// to the Bootstrap", eq. 11.5 and section 12.5). No interval with fewer than two repetitions or an
/// undefined v_i; empty if the statistic is undefined.
std::optional<Estimate> jackknife(std::size_t repetitions, const RepetitionStatistic& statistic);

/// Returns the jackknife of a ratio (> 0), computed on its logarithm.
std::optional<Estimate> jackknife_ratio(std::size_t repetitions, const RepetitionStatistic& ratio);

}  // namespace foveola::analysis
