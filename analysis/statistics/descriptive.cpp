#include "analysis/statistics/descriptive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/statistics/distributions.h"
#include "analysis/statistics/logarithms.h"
#include "renderer/base/numbers/quantile.h"

namespace foveola::analysis {
namespace {

bool is_above_rounding(double deviation, std::span<const double> values) {
  constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
  double largest = 0.0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  return deviation > rounding * largest;
}

}  // namespace

std::optional<double> mean(std::span<const double> values) {
  if (values.empty()) {
    return std::nullopt;
  }
  return static_cast<double>(extended_mean(values));
}

std::optional<double> standard_deviation(std::span<const double> values) {
  if (values.size() < 2) {
    return std::nullopt;
  }
  const long double center = extended_mean(values);
  long double squares = 0.0L;
  for (const double value : values) {
    squares += (value - center) * (value - center);
  }
  return static_cast<double>(std::sqrt(squares / static_cast<long double>(values.size() - 1)));
}

bool varies(std::span<const double> values) {
  const std::optional<double> deviation = standard_deviation(values);
  return deviation && is_above_rounding(*deviation, values);
}

Description describe(std::span<const double> values) {
  return {values.size(), mean(values), standard_deviation(values), median(values)};
}

std::optional<Estimate> mean_estimate(std::span<const double> values, double confidence) {
  Description described = describe(values);
  if (!varies(values)) {
    described.standard_deviation.reset();
  }
  return mean_estimate(described, confidence);
}

std::optional<Estimate> mean_estimate(const Description& description, double confidence) {
  if (!description.mean) {
    return std::nullopt;
  }
  Estimate estimate{description.n, *description.mean, std::nullopt};
  const double deviation = description.standard_deviation.value_or(0.0);
  if (description.n > 1 && deviation > 0.0) {
    const auto n = static_cast<double>(description.n);
    const double half_width = student_t_quantile(confidence, n - 1.0) * deviation / std::sqrt(n);
    estimate.interval = {estimate.value - half_width, estimate.value + half_width};
  }
  return estimate;
}

std::optional<Estimate> geometric_mean(std::span<const double> values, double confidence) {
  return geometric_mean_of_logs(logarithms(values), confidence);
}

std::optional<Estimate> geometric_mean_of_logs(std::span<const double> logs, double confidence) {
  std::optional<Estimate> estimate = mean_estimate(logs, confidence);
  if (!estimate) {
    return std::nullopt;
  }
  estimate->value = std::exp(estimate->value);
  if (standard_deviation(logs).value_or(0.0) <= rounding_of_logarithms) {
    estimate->interval.reset();
  }
  if (estimate->interval) {
    estimate->interval = exp_of(*estimate->interval);
  }
  return estimate;
}

}  // namespace foveola::analysis
