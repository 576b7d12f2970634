// Error as a function of samples and of seconds, read off at equal error.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/convergence/measurement.h"

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

}  // namespace foveola::analysis
