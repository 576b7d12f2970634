#include "analysis/convergence/convergence_tables.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/convergence/jackknife.h"

namespace foveola::analysis {
namespace {

/// The position of the contender that the others are compared with.
constexpr std::size_t baseline_contender = 0;

using Rounds = std::span<const std::size_t>;

/// The point of a curve where all of a render's samples are taken, or a quarter; empty if no error
/// can be compared there.
std::optional<CurvePoint> point_of(Level level, const ErrorCurve& curve,
                                   const GazeMeasurement& measurement) {
  constexpr double quarter = 0.25;
  const auto all_samples = static_cast<double>(
      measurement.rounds.front()[baseline_contender].checkpoints.back().samples);
  const double wanted = all_samples * (level == Level::all ? 1.0 : quarter);
  // Checkpoints are whole samples.
  const auto found = std::find_if(curve.begin(), curve.end(), [wanted](const CurvePoint& point) {
    return std::abs(point.samples - wanted) <= 1.0;
  });
  return found != curve.end() ? std::optional(*found) : std::nullopt;
}

/// How far the slower curve has come, over what the faster one needed for the same error.
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
  base.contender = baseline_contender;
  return jackknife_ratio(measurement.rounds.size(), [&](Rounds kept) {
    return speed_up(mean_curve(measurement, source, kept), mean_curve(measurement, base, kept),
                    measurement, level, axis);
  });
}

void add_speed_ups(const GazeMeasurement& measurement, std::size_t contender,
                   std::vector<SpeedUp>& rows) {
  for (std::size_t region = 0; region < measurement.regions.size(); ++region) {
    for (const Metric metric : metrics) {
      for (const Level level : levels) {
        const CurveSource source{.contender = contender, .region = region, .metric = metric};
        rows.push_back({.scene = measurement.scene,
                        .gaze = measurement.gaze,
                        .contender = measurement.contenders[contender],
                        .region = measurement.regions[region],
                        .metric = metric,
                        .level = level,
                        .samples = speed_up(measurement, source, level, Axis::samples),
                        .time = speed_up(measurement, source, level, Axis::seconds),
                        .predicted = metric == Metric::mse
                                         ? measurement.predicted[contender][region]
                                         : std::nullopt});
      }
    }
  }
}

double seconds_per_path(const GazeMeasurement& measurement, std::size_t contender, Rounds kept) {
  double time_s = 0.0;
  double samples = 0.0;
  for (const std::size_t round : kept) {
    const Checkpoint& end = measurement.rounds[round][contender].checkpoints.back();
    time_s += end.seconds;
    samples += static_cast<double>(end.samples);
  }
  return time_s / samples;
}

PathCost cost_of(const GazeMeasurement& measurement, std::size_t contender) {
  constexpr double ns_per_s = 1e9;
  const std::size_t rounds = measurement.rounds.size();
  return {
      .scene = measurement.scene,
      .gaze = measurement.gaze,
      .contender = measurement.contenders[contender],
      .ns_per_path = jackknife_ratio(
          rounds,
          [&](Rounds kept) { return ns_per_s * seconds_per_path(measurement, contender, kept); }),
      .ratio = jackknife_ratio(rounds, [&](Rounds kept) {
        return seconds_per_path(measurement, contender, kept) /
               seconds_per_path(measurement, baseline_contender, kept);
      })};
}

std::optional<Estimate> slope(const GazeMeasurement& measurement, const CurveSource& source,
                              Axis axis) {
  return jackknife(measurement.rounds.size(), [&](Rounds kept) -> std::optional<double> {
    const std::optional<double> exponent =
        log_log_slope(mean_curve(measurement, source, kept), axis);
    return exponent ? std::optional(0.5 * *exponent) : std::nullopt;  // the root's
  });
}

/// Empty where the last error cannot be compared.
std::optional<double> efficiency(const GazeMeasurement& measurement, std::size_t contender,
                                 std::size_t region, Rounds kept) {
  const ErrorCurve curve = mean_curve(
      measurement, {.contender = contender, .region = region, .metric = Metric::mse}, kept);
  const std::uint64_t last = measurement.rounds.front()[contender].checkpoints.back().samples;
  if (curve.empty() || std::abs(curve.back().samples - static_cast<double>(last)) > 1.0) {
    return std::nullopt;
  }
  return 1.0 / (curve.back().error * curve.back().seconds);
}

Convergence convergence_of(const GazeMeasurement& measurement, std::size_t contender,
                           std::size_t region) {
  const CurveSource source{.contender = contender, .region = region, .metric = Metric::mse};
  const std::size_t rounds = measurement.rounds.size();
  return {
      .scene = measurement.scene,
      .gaze = measurement.gaze,
      .contender = measurement.contenders[contender],
      .region = measurement.regions[region],
      .slope_in_samples = slope(measurement, source, Axis::samples),
      .slope_in_time = slope(measurement, source, Axis::seconds),
      .efficiency = jackknife_ratio(
          rounds, [&](Rounds kept) { return efficiency(measurement, contender, region, kept); }),
      .efficiency_ratio = jackknife_ratio(rounds, [&](Rounds kept) -> std::optional<double> {
        const auto own = efficiency(measurement, contender, region, kept);
        const auto base = efficiency(measurement, baseline_contender, region, kept);
        return own && base ? std::optional(*own / *base) : std::nullopt;
      })};
}

using Kind = std::vector<const SpeedUp*>;

/// The geometric mean of what all rows of a kind have, empty unless every one of them has it; of a
/// single row its own estimate.
std::optional<Estimate> over_all(const Kind& rows, std::optional<Estimate> SpeedUp::*estimate) {
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
  return a.contender == b.contender && a.region == b.region && a.metric == b.metric &&
         a.level == b.level;
}

std::vector<OverallSpeedUp> overall_speed_ups(const std::vector<SpeedUp>& rows) {
  std::vector<OverallSpeedUp> overall;
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
    overall.push_back({.contender = first->contender,
                       .region = first->region,
                       .metric = first->metric,
                       .level = first->level,
                       .samples = over_all(kind, &SpeedUp::samples),
                       .time = over_all(kind, &SpeedUp::time),
                       .predicted = predicted_over_all(kind)});
  }
  return overall;
}

}  // namespace

std::string_view name_of(Level level) { return level == Level::all ? "all" : "quarter"; }

ConvergenceTables tabulate(const std::vector<GazeMeasurement>& measurements) {
  ConvergenceTables tables;
  for (const GazeMeasurement& measurement : measurements) {
    for (std::size_t contender = 0; contender < measurement.contenders.size(); ++contender) {
      if (contender != baseline_contender) {
        add_speed_ups(measurement, contender, tables.speed_ups);
      }
      tables.costs.push_back(cost_of(measurement, contender));
      for (std::size_t region = 0; region < measurement.regions.size(); ++region) {
        tables.convergence.push_back(convergence_of(measurement, contender, region));
      }
    }
  }
  tables.overall = overall_speed_ups(tables.speed_ups);
  return tables;
}

}  // namespace foveola::analysis
