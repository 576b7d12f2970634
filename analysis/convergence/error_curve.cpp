#include "analysis/convergence/error_curve.h"

#include <cmath>
#include <numeric>

#include "analysis/statistics/distributions.h"

namespace foveola::analysis {
namespace {

std::optional<double> half_width(const std::vector<std::size_t>& all,
                                 const RepetitionStatistic& statistic) {
  const auto n = static_cast<double>(all.size());
  if (all.size() < 2) {
    return std::nullopt;
  }
  std::vector<double> values;
  for (const std::size_t left_out : all) {
    std::vector<std::size_t> kept = all;
    std::erase(kept, left_out);
    const std::optional<double> value = statistic(kept);
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  const double mean_value = *mean(values);
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - mean_value) * (value - mean_value);
  }
  return student_t_quantile(default_confidence, n - 1.0) * std::sqrt((n - 1.0) / n * squares);
}

constexpr double least_samples_per_pixel = 2.0;
constexpr double max_empty_share = 0.02;

/// Returns NaN if a region has no such error.
double error_of(const Score& score, Metric metric) {
  switch (metric) {
    case Metric::mse:
      return score.error.mse;
    case Metric::relative_mse:
      return score.error.relative_mse;
    case Metric::flip:
      break;
  }
  return score.flip.value_or(std::nan(""));
}

bool can_be_compared(const CurvePoint& point) {
  return point.samples_per_pixel >= least_samples_per_pixel &&
         point.empty_share <= max_empty_share && point.error > 0.0;
}

}  // namespace

std::string_view name_of(Metric metric) {
  switch (metric) {
    case Metric::mse:
      return "mse";
    case Metric::relative_mse:
      return "relative_mse";
    case Metric::flip:
      break;
  }
  return "flip";
}

ErrorCurve mean_curve(const GazeMeasurement& measurement, const CurveSource& source,
                      std::span<const std::size_t> kept) {
  ErrorCurve curve;
  const std::size_t count =
      measurement.repetitions.front()[source.configuration].checkpoints.size();
  const double share = 1.0 / static_cast<double>(kept.size());
  for (std::size_t i = 0; i < count; ++i) {
    CurvePoint point;
    for (const std::size_t repetition : kept) {
      const Checkpoint& checkpoint =
          measurement.repetitions[repetition][source.configuration].checkpoints[i];
      const Score& score = checkpoint.scores[source.region];
      point.samples += share * static_cast<double>(checkpoint.samples);
      point.seconds += share * checkpoint.seconds;
      point.error += share * error_of(score, source.metric);
      point.samples_per_pixel += share * score.error.samples_per_pixel;
      point.empty_share += share * score.error.empty_share;
    }
    if (can_be_compared(point)) {
      curve.push_back(point);
    }
  }
  return curve;
}

std::optional<double> reach(const ErrorCurve& curve, double error, Axis axis) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const CurvePoint& point = curve[i];
    if (point.error <= error) {
      if (point.error == error) {
        return point.along(axis);
      }
      if (i == 0) {
        return std::nullopt;
      }
      const CurvePoint& before = curve[i - 1];
      const double t = std::log(before.error / error) / std::log(before.error / point.error);
      return before.along(axis) * std::pow(point.along(axis) / before.along(axis), t);
    }
  }
  return std::nullopt;
}

std::optional<double> log_log_slope(const ErrorCurve& curve, Axis axis) {
  if (curve.size() < 3) {
    return std::nullopt;
  }
  double mean_x = 0.0;
  double mean_y = 0.0;
  const double share = 1.0 / static_cast<double>(curve.size());
  for (const CurvePoint& point : curve) {
    mean_x += share * std::log(point.along(axis));
    mean_y += share * std::log(point.error);
  }
  double xx = 0.0;
  double xy = 0.0;
  for (const CurvePoint& point : curve) {
    const double x = std::log(point.along(axis)) - mean_x;
    xx += x * x;
    xy += x * (std::log(point.error) - mean_y);
  }
  return xy / xx;
}

std::optional<Estimate> jackknife(std::size_t repetitions, const RepetitionStatistic& statistic) {
  std::vector<std::size_t> all(repetitions);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::optional<double> value = repetitions > 0 ? statistic(all) : std::nullopt;
  if (!value) {
    return std::nullopt;
  }
  Estimate estimate{.n = repetitions, .value = *value};
  if (const std::optional<double> half = half_width(all, statistic)) {
    estimate.interval = Interval{*value - *half, *value + *half};
  }
  return estimate;
}

std::optional<Estimate> jackknife_ratio(std::size_t repetitions, const RepetitionStatistic& ratio) {
  std::optional<Estimate> estimate =
      jackknife(repetitions, [&](std::span<const std::size_t> kept) -> std::optional<double> {
        const std::optional<double> value = ratio(kept);
        return value ? std::optional(std::log(*value)) : std::nullopt;
      });
  if (estimate) {
    estimate->value = std::exp(estimate->value);
    if (estimate->interval) {
      estimate->interval->low = std::exp(estimate->interval->low);
      estimate->interval->high = std::exp(estimate->interval->high);
    }
  }
  return estimate;
}

}  // namespace foveola::analysis
