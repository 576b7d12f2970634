#include "analysis/statistics/survival.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "analysis/statistics/distributions.h"

namespace foveola::analysis {
namespace {

/// Returns a step's addition to the variance of the log survival (Greenwood 1926); 0 if nobody
/// remains at risk.
long double greenwood_term(const SurvivalStep& step) {
  if (step.events == step.at_risk) {
    return 0.0L;
  }
  const auto at_risk = static_cast<long double>(step.at_risk);
  const auto events = static_cast<long double>(step.events);
  return events / (at_risk * (at_risk - events));
}

std::vector<SurvivalStep> count_steps(std::span<const TimeToMark> times) {
  std::vector<TimeToMark> sorted(times.begin(), times.end());
  std::ranges::sort(sorted,
                    [](const TimeToMark& a, const TimeToMark& b) { return a.time < b.time; });
  std::vector<SurvivalStep> steps;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (steps.empty() || steps.back().time != sorted[i].time) {
      steps.push_back({.time = sorted[i].time, .at_risk = sorted.size() - i});
    }
    ++(sorted[i].censored ? steps.back().censored : steps.back().events);
  }
  return steps;
}

/// exp(-exp(log(-log S) -+ z se(log S) / log S)).
std::optional<Interval> log_log_interval(double survival, double log_error, double z) {
  if (survival <= 0.0 || survival >= 1.0) {
    return std::nullopt;
  }
  const double hazard = -std::log(survival);
  const double width = z * log_error / hazard;
  return Interval{std::exp(-hazard * std::exp(width)), std::exp(-hazard * std::exp(-width))};
}

/// Returns the first time at which `level_of` a step is a half or less; if it is exactly a half for
/// a while, the midpoint of that while. Steps without a level are skipped.
template <typename Level>
std::optional<double> time_of_half(const std::vector<SurvivalStep>& steps, const Level& level_of) {
  constexpr double tolerance = 1.5e-8;  // as in R
  const auto reaches = [&](double level) {
    return [&, level](const SurvivalStep& step) {
      const std::optional<double> own = level_of(step);
      return own && *own < level;
    };
  };
  const auto half = std::ranges::find_if(steps, reaches(0.5 + tolerance));
  if (half == steps.end()) {
    return std::nullopt;
  }
  const double level = *level_of(*half);
  if (std::abs(level - 0.5) < tolerance) {
    const auto below = std::find_if(half, steps.end(), reaches(level));
    if (below != steps.end()) {
      return (half->time + below->time) / 2.0;
    }
  }
  return half->time;
}

std::optional<SurvivalMedian> median_of(const std::vector<SurvivalStep>& steps) {
  const auto median =
      time_of_half(steps, [](const SurvivalStep& step) { return std::optional(step.survival); });
  if (!median) {
    return std::nullopt;
  }
  const auto end_of = [&](double Interval::* end) {
    return time_of_half(steps, [=](const SurvivalStep& step) {
      return step.interval ? std::optional((*step.interval).*end) : std::nullopt;
    });
  };
  return SurvivalMedian{*median, end_of(&Interval::low), end_of(&Interval::high)};
}

}  // namespace

SurvivalCurve kaplan_meier(std::span<const TimeToMark> times, double confidence) {
  SurvivalCurve curve;
  curve.n = times.size();
  curve.steps = count_steps(times);
  const double z = normal_two_sided_quantile(confidence);
  long double survival = 1.0L;
  long double log_variance = 0.0L;
  for (SurvivalStep& step : curve.steps) {
    curve.events += step.events;
    curve.censored += step.censored;
    survival *= static_cast<long double>(step.at_risk - step.events) /
                static_cast<long double>(step.at_risk);
    log_variance += greenwood_term(step);
    const auto log_error = static_cast<double>(std::sqrt(log_variance));
    step.survival = static_cast<double>(survival);
    if (step.survival > 0.0) {
      step.standard_error = step.survival * log_error;
    }
    step.interval = log_log_interval(step.survival, log_error, z);
  }
  curve.median = median_of(curve.steps);
  return curve;
}

std::optional<RestrictedMean> restricted_mean(const SurvivalCurve& curve, double horizon) {
  assert(horizon > 0.0);
  if (curve.steps.empty()) {
    return std::nullopt;
  }
  const auto past = std::ranges::find_if(
      curve.steps, [&](const SurvivalStep& step) { return step.time > horizon; });
  // From the horizon backwards: the area after each step is its weight in the variance.
  long double area = 0.0L;
  long double variance = 0.0L;
  double end = horizon;
  for (auto step = std::make_reverse_iterator(past); step != curve.steps.rend(); ++step) {
    area += static_cast<long double>(step->survival) * (end - step->time);
    variance += area * area * greenwood_term(*step);
    end = step->time;
  }
  return RestrictedMean{horizon, static_cast<double>(area + end),
                        static_cast<double>(std::sqrt(variance))};
}

}  // namespace foveola::analysis
