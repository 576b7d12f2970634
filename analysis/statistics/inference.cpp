#include "analysis/statistics/inference.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/statistics/extended_mean.h"
#include "analysis/statistics/normal.h"
#include "analysis/statistics/student_t.h"

namespace foveola::analysis {
namespace {

bool is_constant(std::span<const double> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *low == *high;
}

double correlation_coefficient(std::span<const double> x, std::span<const double> y) {
  const long double x_mean = extended_mean(x);
  const long double y_mean = extended_mean(y);
  long double xx = 0.0L;
  long double yy = 0.0L;
  long double xy = 0.0L;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const long double dx = x[i] - x_mean;
    const long double dy = y[i] - y_mean;
    xx += dx * dx;
    yy += dy * dy;
    xy += dx * dy;
  }
  return std::clamp(static_cast<double>(xy / std::sqrt(xx) / std::sqrt(yy)), -1.0, 1.0);
}

}  // namespace

Interval fisher_interval(double r, double half_width) {
  const double z = std::atanh(r);
  return {std::tanh(z - half_width), std::tanh(z + half_width)};
}

std::optional<Correlation> pearson(std::span<const double> x, std::span<const double> y,
                                   double confidence) {
  assert(x.size() == y.size());
  if (x.size() < 3 || is_constant(x) || is_constant(y)) {
    return std::nullopt;
  }
  Correlation result;
  result.n = x.size();
  result.r = correlation_coefficient(x, y);
  const double degrees_of_freedom = static_cast<double>(result.n) - 2.0;
  result.t = result.r * std::sqrt(degrees_of_freedom / ((1.0 - result.r) * (1.0 + result.r)));
  result.p = student_t_two_sided(result.t, degrees_of_freedom);
  if (result.n > 3) {
    result.interval = fisher_interval(result.r, normal_two_sided_quantile(confidence) /
                                                    std::sqrt(static_cast<double>(result.n) - 3.0));
  }
  return result;
}

}  // namespace foveola::analysis
