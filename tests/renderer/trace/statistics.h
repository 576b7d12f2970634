// Statistics that the tests of random estimators share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

namespace foveola {

/// Mean and standard error of values that come one after the other (Welford 1962).
class MeanEstimate {
 public:
  void add(double value) {
    ++count_;
    const double delta = value - mean_;
    mean_ += delta / static_cast<double>(count_);
    squares_ += delta * (value - mean_);
  }
  double mean() const { return mean_; }
  double standard_error() const {
    const auto n = static_cast<double>(count_);
    return std::sqrt(squares_ / (n - 1.0) / n);
  }

 private:
  std::size_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;
};

/// Within 5 standard errors of the expected value, and of at most the given relative standard
/// error, so that the test has power. `exactness` is what the expected value itself may be off.
inline void expect_mean(const MeanEstimate& estimate, double expected, double exactness = 1e-5,
                        double largest_relative_error = 0.01) {
  EXPECT_LE(estimate.standard_error(), largest_relative_error * std::abs(expected));
  EXPECT_NEAR(estimate.mean(), expected,
              5.0 * estimate.standard_error() + exactness * std::abs(expected));
}

/// The probability of a chi-squared statistic at least as large, if `expected` counts were true.
/// Bins of fewer than five expected counts are pooled.
inline double chi_squared_p_value(const std::vector<double>& observed,
                                  const std::vector<double>& expected) {
  double statistic = 0.0;
  double pooled_observed = 0.0;
  double pooled_expected = 0.0;
  int bins = 0;
  const auto add_bin = [&](double o, double e) {
    statistic += (o - e) * (o - e) / e;
    ++bins;
  };
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (expected[i] >= 5.0) {
      add_bin(observed[i], expected[i]);
    } else {
      pooled_observed += observed[i];
      pooled_expected += expected[i];
    }
  }
  if (pooled_expected >= 5.0) {
    add_bin(pooled_observed, pooled_expected);
  } else if (pooled_observed > 5.0 + 10.0 * std::sqrt(pooled_expected)) {
    return 0.0;
  }
  return boost::math::cdf(
      boost::math::complement(boost::math::chi_squared(std::max(1, bins - 1)), statistic));
}

/// The level of each of `tests` tests that together err with probability 0.001 (Sidak 1967).
inline double sidak_level(int tests) { return 1.0 - std::pow(1.0 - 0.001, 1.0 / tests); }

}  // namespace foveola
