#include "analysis/statistics/censored_mean.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/statistics/normal.h"
#include "analysis/statistics/student_t.h"

namespace foveola::analysis {
namespace {

constexpr double log_root_two_pi = 0.91893853320467274178;

/// A log-likelihood with its first and second derivatives by mean and logarithm of the deviation.
struct LogLikelihood {
  double value = 0.0;
  double by_mean = 0.0;
  double by_scale = 0.0;
  double by_mean_mean = 0.0;
  double by_mean_scale = 0.0;
  double by_scale_scale = 0.0;
};

void add_measured(double z, double deviation, LogLikelihood& sum) {
  sum.value += -0.5 * z * z - std::log(deviation) - log_root_two_pi;
  sum.by_mean += z / deviation;
  sum.by_scale += z * z - 1.0;
  sum.by_mean_mean += -1.0 / (deviation * deviation);
  sum.by_mean_scale += -2.0 * z / deviation;
  sum.by_scale_scale += -2.0 * z * z;
}

/// The density over the upper tail of the standard normal; far out by its continued fraction, where
/// both underflow.
double hazard(double z) {
  constexpr double far_out = 30.0;
  if (z > far_out) {
    return z + 1.0 / (z + 2.0 / (z + 3.0 / (z + 4.0 / z)));
  }
  return std::exp(-0.5 * z * z - log_root_two_pi) / normal_cdf(-z);
}

double log_upper_tail(double z) {
  constexpr double far_out = 30.0;
  return z > far_out ? -0.5 * z * z - log_root_two_pi - std::log(hazard(z))
                     : std::log(normal_cdf(-z));
}

/// A value that lies beyond the bound at z; `side` is +1 above it, -1 below it.
void add_censored(double z, double side, double deviation, LogLikelihood& sum) {
  const double outward = side * z;
  const double h = hazard(outward);
  const double slope = h * (h - outward);  // of the hazard
  sum.value += log_upper_tail(outward);
  sum.by_mean += side * h / deviation;
  sum.by_scale += outward * h;
  sum.by_mean_mean += -slope / (deviation * deviation);
  sum.by_mean_scale += -side * (h + outward * slope) / deviation;
  sum.by_scale_scale += -outward * (h + outward * slope);
}

LogLikelihood log_likelihood(const std::vector<BoundedValue>& values, double mean,
                             double log_deviation) {
  const double deviation = std::exp(log_deviation);
  LogLikelihood sum;
  for (const BoundedValue& value : values) {
    if (value.is_exact()) {
      add_measured((value.low - mean) / deviation, deviation, sum);
    } else if (std::isfinite(value.low)) {
      add_censored((value.low - mean) / deviation, 1.0, deviation, sum);
    } else {
      add_censored((value.high - mean) / deviation, -1.0, deviation, sum);
    }
  }
  return sum;
}

/// In units of the measured values: their mean is 0, their deviation 1.
struct Peak {
  double mean = 0.0;
  double log_deviation = 0.0;
  LogLikelihood likelihood;
};

/// Newton's method, each step halved until the likelihood grows; from the measured values. The
/// step is along the gradient where the likelihood is not concave.
std::optional<Peak> climb(const std::vector<BoundedValue>& values) {
  constexpr int most_steps = 200;
  constexpr double small_step = 1e-13;
  Peak peak{0.0, 0.0, log_likelihood(values, 0.0, 0.0)};
  for (int step = 0; step < most_steps; ++step) {
    const LogLikelihood& at = peak.likelihood;
    const double determinant =
        at.by_mean_mean * at.by_scale_scale - at.by_mean_scale * at.by_mean_scale;
    const bool concave = at.by_mean_mean < 0.0 && determinant > 0.0;
    double by_mean = at.by_mean;
    double by_scale = at.by_scale;
    if (concave) {
      by_mean = -(at.by_scale_scale * at.by_mean - at.by_mean_scale * at.by_scale) / determinant;
      by_scale = -(at.by_mean_mean * at.by_scale - at.by_mean_scale * at.by_mean) / determinant;
    }
    const double longest = std::max(std::abs(by_mean), std::abs(by_scale));
    if (concave && longest < small_step) {
      return peak;
    }
    double fraction = std::min(1.0, 1.0 / longest);
    Peak next;
    do {
      next.mean = peak.mean + fraction * by_mean;
      next.log_deviation = peak.log_deviation + fraction * by_scale;
      next.likelihood = log_likelihood(values, next.mean, next.log_deviation);
      fraction /= 2.0;
    } while (!(next.likelihood.value >= at.value) && fraction > small_step);
    if (!(next.likelihood.value >= at.value)) {
      return concave ? std::optional(peak) : std::nullopt;  // as near as rounding lets it
    }
    peak = next;
  }
  return peak;
}

struct Sample {
  std::vector<BoundedValue> values;  ///< those that say something
  std::vector<double> measured;
};

Sample sample_of(std::span<const BoundedValue> values) {
  Sample sample;
  for (const BoundedValue& value : values) {
    if (!value.is_unknown()) {
      sample.values.push_back(value);
    }
    if (value.is_exact()) {
      sample.measured.push_back(value.low);
    }
  }
  return sample;
}

}  // namespace

bool BoundedValue::is_unknown() const { return std::isinf(low) && std::isinf(high); }

BoundedValue difference(const BoundedValue& a, const BoundedValue& b) {
  return {a.low - b.high, a.high - b.low};
}

std::optional<CensoredMean> censored_mean(std::span<const BoundedValue> values, double confidence) {
  Sample sample = sample_of(values);
  const std::optional<double> unit = standard_deviation(sample.measured);
  if (!unit || *unit == 0.0) {
    return std::nullopt;
  }
  const double origin = *mean(sample.measured);
  for (BoundedValue& value : sample.values) {
    value = {(value.low - origin) / *unit, (value.high - origin) / *unit};
  }
  const std::optional<Peak> peak = climb(sample.values);
  if (!peak) {
    return std::nullopt;
  }
  const LogLikelihood& at = peak->likelihood;
  const double determinant =
      at.by_mean_mean * at.by_scale_scale - at.by_mean_scale * at.by_mean_scale;
  CensoredMean result;
  result.n = sample.values.size();
  result.censored = result.n - sample.measured.size();
  result.unknown = values.size() - result.n;
  const auto n = static_cast<double>(result.n);
  const double small_sample = std::sqrt(n / (n - 1.0));
  result.mean = origin + *unit * peak->mean;
  result.standard_deviation = *unit * std::exp(peak->log_deviation) * small_sample;
  result.standard_error = *unit * std::sqrt(-at.by_scale_scale / determinant) * small_sample;
  const double half_width = student_t_quantile(confidence, n - 1.0) * result.standard_error;
  result.interval = {result.mean - half_width, result.mean + half_width};
  result.t = result.mean / result.standard_error;
  result.p = student_t_two_sided(result.t, n - 1.0);
  return result;
}

}  // namespace foveola::analysis
