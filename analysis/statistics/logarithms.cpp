#include "analysis/statistics/logarithms.h"

#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "analysis/statistics/distributions.h"
#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

/// Adds `factor` times one logarithm of means to another of the same participants.
void add(const LogOfMeans& term, double factor, LogOfMeans& sum) {
  assert(term.influences.size() == sum.influences.size());
  sum.value += factor * term.value;
  for (std::size_t i = 0; i < term.influences.size(); ++i) {
    if (term.influences[i]) {
      sum.influences[i] = sum.influences[i].value_or(0.0) + factor * *term.influences[i];
    }
  }
}

}  // namespace

std::optional<LogOfMeans> log_of_mean(std::span<const std::optional<double>> values) {
  std::vector<double> present;
  for (const std::optional<double>& value : values) {
    if (value) {
      present.push_back(*value);
    }
  }
  const std::optional<double> center = mean(present);
  if (!center) {
    return std::nullopt;
  }
  LogOfMeans result{std::log(*center), {}};
  const auto n = static_cast<double>(present.size());
  for (const std::optional<double>& value : values) {
    result.influences.push_back(value ? std::optional((*value - *center) / (n * *center))
                                      : std::nullopt);
  }
  return result;
}

LogOfMeans log_of_ratio(const LogOfMeans& numerator, const LogOfMeans& denominator) {
  LogOfMeans ratio = numerator;
  add(denominator, -1.0, ratio);
  return ratio;
}

LogOfMeans log_of_geometric_mean(std::span<const LogOfMeans> means) {
  LogOfMeans result{0.0, std::vector<std::optional<double>>(means.front().influences.size())};
  for (const LogOfMeans& mean : means) {
    add(mean, 1.0 / static_cast<double>(means.size()), result);
  }
  return result;
}

Estimate estimate_of(const LogOfMeans& logarithm, double confidence) {
  std::size_t n = 0;
  double squares = 0.0;
  for (const std::optional<double>& influence : logarithm.influences) {
    n += influence ? 1 : 0;
    squares += influence.value_or(0.0) * influence.value_or(0.0);
  }
  Estimate estimate{n, std::exp(logarithm.value), std::nullopt};
  if (n < 2) {
    return estimate;
  }
  const auto count = static_cast<double>(n);
  const double standard_error = std::sqrt(count / (count - 1.0) * squares);
  if (standard_error > rounding_of_logarithms) {
    const double half_width = student_t_quantile(confidence, count - 1.0) * standard_error;
    estimate.interval = exp_of({logarithm.value - half_width, logarithm.value + half_width});
  }
  return estimate;
}

std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> logs;
  logs.reserve(values.size());
  for (const double value : values) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      throw Error(fmt::format("value {} of {}", logs.size() + 1, values.size()),
                  fmt::format("{} is not above zero", value),
                  "remove it: a geometric mean needs values above zero");
    }
    logs.push_back(std::log(value));
  }
  return logs;
}

Interval exp_of(const Interval& logs) { return {std::exp(logs.low), std::exp(logs.high)}; }

}  // namespace foveola::analysis
