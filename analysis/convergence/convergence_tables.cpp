#include "analysis/convergence/convergence_tables.h"

#include <algorithm>
#include <cmath>

namespace foveola::analysis {
namespace {

/// Position of the configuration that the others are compared with.
constexpr std::size_t baseline_configuration = 0;

using Repetitions = std::span<const std::size_t>;

/// Returns the point of a curve with all of a render's samples, or a quarter; empty if its error
/// cannot be compared.
std::optional<CurvePoint> point_of(Level level, const ErrorCurve& curve,
                                   const GazeMeasurement& measurement) {
  constexpr double quarter = 0.25;
  const auto all_samples = static_cast<double>(
      measurement.repetitions.front()[baseline_configuration].checkpoints.back().samples);
  const double wanted = all_samples * (level == Level::all ? 1.0 : quarter);
  // Checkpoints are at whole samples.
  const auto found = std::ranges::find_if(
      curve, [wanted](const CurvePoint& point) { return std::abs(point.samples - wanted) <= 1.0; });
  return found != curve.end() ? std::optional(*found) : std::nullopt;
}

/// Returns the slower curve's position over the faster one's, at the same error.
std::optional<double> speed_up(const ErrorCurve& method, const ErrorCurve& base,
                               const GazeMeasurement& measurement, Level level, Axis axis) {
  const std::optional<CurvePoint> method_end = point_of(level, method, measurement);
  const std::optional<CurvePoint> base_end = point_of(level, base, measurement);
  if (!base_end) {
    return std::nullopt;
  }
  if (method_end && method_end->error > base_end->error) {
    const std::optional<double> needed = reach(base, method_end->error, axis);
    return needed ? std::optional(*needed / method_end->along(axis)) : std::nullopt;
  }
  const std::optional<double> needed = reach(method, base_end->error, axis);
  return needed ? std::optional(base_end->along(axis) / *needed) : std::nullopt;
}

std::optional<Estimate> speed_up(const GazeMeasurement& measurement, const CurveSource& source,
                                 Level level, Axis axis) {
  CurveSource base = source;
  base.configuration = baseline_configuration;
  return jackknife_ratio(measurement.repetitions.size(), [&](Repetitions kept) {
    return speed_up(mean_curve(measurement, source, kept), mean_curve(measurement, base, kept),
                    measurement, level, axis);
  });
}

void add_speed_ups(const GazeMeasurement& measurement, std::size_t configuration,
                   std::vector<SpeedUp>& rows) {
  for (std::size_t region = 0; region < measurement.regions.size(); ++region) {
    for (const Metric metric : metrics) {
      for (const Level level : levels) {
        const CurveSource source{
            .configuration = configuration, .region = region, .metric = metric};
        rows.push_back({.scene = measurement.scene,
                        .gaze = measurement.gaze,
                        .configuration = measurement.configurations[configuration],
                        .region = measurement.regions[region],
                        .metric = metric,
                        .level = level,
                        .samples_ratio = speed_up(measurement, source, level, Axis::samples),
                        .time_ratio = speed_up(measurement, source, level, Axis::seconds),
                        .predicted = metric == Metric::mse
                                         ? measurement.predicted[configuration][region]
                                         : std::nullopt});
      }
    }
  }
}

double seconds_per_path(const GazeMeasurement& measurement, std::size_t configuration,
                        Repetitions kept) {
  double time_s = 0.0;
  double samples = 0.0;
  for (const std::size_t repetition : kept) {
    const Checkpoint& end = measurement.repetitions[repetition][configuration].checkpoints.back();
    time_s += end.seconds;
    samples += static_cast<double>(end.samples);
  }
  return time_s / samples;
}

PathCost cost_of(const GazeMeasurement& measurement, std::size_t configuration) {
  constexpr double ns_per_s = 1e9;
  const std::size_t repetitions = measurement.repetitions.size();
  return {.scene = measurement.scene,
          .gaze = measurement.gaze,
          .configuration = measurement.configurations[configuration],
          .ns_per_path = jackknife_ratio(repetitions,
                                         [&](Repetitions kept) {
                                           return ns_per_s * seconds_per_path(measurement,
                                                                              configuration, kept);
                                         }),
          .ratio = jackknife_ratio(repetitions, [&](Repetitions kept) {
            return seconds_per_path(measurement, configuration, kept) /
                   seconds_per_path(measurement, baseline_configuration, kept);
          })};
}

std::optional<Estimate> slope(const GazeMeasurement& measurement, const CurveSource& source,
                              Axis axis) {
  return jackknife(measurement.repetitions.size(), [&](Repetitions kept) -> std::optional<double> {
    const std::optional<double> exponent =
        log_log_slope(mean_curve(measurement, source, kept), axis);
    return exponent ? std::optional(0.5 * *exponent) : std::nullopt;  // the root's
  });
}

/// Empty if the last error cannot be compared.
std::optional<double> efficiency(const GazeMeasurement& measurement, std::size_t configuration,
                                 std::size_t region, Repetitions kept) {
  const ErrorCurve curve = mean_curve(
      measurement, {.configuration = configuration, .region = region, .metric = Metric::mse}, kept);
  const std::uint64_t last =
      measurement.repetitions.front()[configuration].checkpoints.back().samples;
  if (curve.empty() || std::abs(curve.back().samples - static_cast<double>(last)) > 1.0) {
    return std::nullopt;
  }
  return 1.0 / (curve.back().error * curve.back().seconds);
}

Convergence convergence_of(const GazeMeasurement& measurement, std::size_t configuration,
                           std::size_t region) {
  const CurveSource source{.configuration = configuration, .region = region, .metric = Metric::mse};
  const std::size_t repetitions = measurement.repetitions.size();
  return {
      .scene = measurement.scene,
      .gaze = measurement.gaze,
      .configuration = measurement.configurations[configuration],
      .region = measurement.regions[region],
      .slope_in_samples = slope(measurement, source, Axis::samples),
      .slope_in_time = slope(measurement, source, Axis::seconds),
      .efficiency = jackknife_ratio(
          repetitions,
          [&](Repetitions kept) { return efficiency(measurement, configuration, region, kept); }),
      .efficiency_ratio =
          jackknife_ratio(repetitions, [&](Repetitions kept) -> std::optional<double> {
            const auto own = efficiency(measurement, configuration, region, kept);
            const auto base = efficiency(measurement, baseline_configuration, region, kept);
            return own && base ? std::optional(*own / *base) : std::nullopt;
          })};
}

using Kind = std::vector<const SpeedUp*>;

/// Returns the geometric mean over all rows of a kind, empty unless every one has an estimate; of a
/// single row its own estimate.
std::optional<Estimate> over_all(const Kind& rows, std::optional<Estimate> SpeedUp::* estimate) {
  if (rows.size() == 1) {
    return rows.front()->*estimate;
  }
  std::vector<double> values;
  for (const SpeedUp* row : rows) {
    if (!(row->*estimate)) {
      return std::nullopt;
    }
    values.push_back((row->*estimate)->value);
  }
  return geometric_mean(values);
}

std::optional<double> predicted_over_all(const Kind& rows) {
  std::vector<double> values;
  for (const SpeedUp* row : rows) {
    if (!row->predicted) {
      return std::nullopt;
    }
    values.push_back(*row->predicted);
  }
  return geometric_mean(values)->value;
}

bool is_same_kind(const SpeedUp& a, const SpeedUp& b) {
  return a.configuration == b.configuration && a.region == b.region && a.metric == b.metric &&
         a.level == b.level;
}

std::vector<SpeedUp> overall_speed_ups(const std::vector<SpeedUp>& rows) {
  std::vector<SpeedUp> overall;
  for (auto first = rows.begin(); first != rows.end(); ++first) {
    if (std::any_of(rows.begin(), first, [&](const auto& r) { return is_same_kind(r, *first); })) {
      continue;
    }
    Kind kind;
    for (const SpeedUp& row : rows) {
      if (is_same_kind(row, *first)) {
        kind.push_back(&row);
      }
    }
    overall.push_back({.configuration = first->configuration,
                       .region = first->region,
                       .metric = first->metric,
                       .level = first->level,
                       .samples_ratio = over_all(kind, &SpeedUp::samples_ratio),
                       .time_ratio = over_all(kind, &SpeedUp::time_ratio),
                       .predicted = predicted_over_all(kind)});
  }
  return overall;
}

}  // namespace

std::string_view name_of(Level level) { return level == Level::all ? "all" : "quarter"; }

ConvergenceTables tabulate(const std::vector<GazeMeasurement>& measurements) {
  ConvergenceTables tables;
  for (const GazeMeasurement& measurement : measurements) {
    for (std::size_t configuration = 0; configuration < measurement.configurations.size();
         ++configuration) {
      if (configuration != baseline_configuration) {
        add_speed_ups(measurement, configuration, tables.speed_ups);
      }
      tables.costs.push_back(cost_of(measurement, configuration));
      for (std::size_t region = 0; region < measurement.regions.size(); ++region) {
        tables.convergence.push_back(convergence_of(measurement, configuration, region));
      }
    }
  }
  tables.overall = overall_speed_ups(tables.speed_ups);
  return tables;
}

}  // namespace foveola::analysis
