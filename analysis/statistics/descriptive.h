// Descriptive statistics: centre, spread, and means with confidence intervals.
#pragma once

#include <cstddef>
#include <numeric>
#include <optional>
#include <span>

namespace foveola::analysis {

// All values are finite. Any values have an estimate. Its interval, like every test, needs two
// values that differ: equal values carry no information on spread. Sums are taken in long double
// around the mean, so that values with a large common offset keep their digits. Results that a
// sample is too small for are empty, never NaN.

std::optional<double> mean(std::span<const double> values);

/// Returns the sample's standard deviation, with n - 1 in the denominator; needs two values.
std::optional<double> standard_deviation(std::span<const double> values);

/// Returns whether at least two values differ by more than their rounding: their standard deviation
/// is above 16 units in the last place of the maximum.
bool varies(std::span<const double> values);

struct Description {
  std::size_t n = 0;
  std::optional<double> mean;
  std::optional<double> standard_deviation;
  std::optional<double> median;
};

Description describe(std::span<const double> values);

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

struct Estimate {
  std::size_t n = 0;
  double value = 0.0;
  std::optional<Interval> interval;  ///< Empty if the values do not vary.
};

inline constexpr double default_confidence = 0.95;

/// Returns the arithmetic mean and its interval from Student's t. Empty for an empty sample.
std::optional<Estimate> mean_estimate(std::span<const double> values,
                                      double confidence = default_confidence);

/// As above, from a sample's printed description: n, mean and standard deviation. Empty without a
/// mean.
std::optional<Estimate> mean_estimate(const Description& description,
                                      double confidence = default_confidence);

/// Returns the geometric mean and its interval, exp(m -+ t s / sqrt(n)) with m and s of the
/// logarithms (Sauro and Lewis 2010, "Average task times in usability tests"). Empty for an empty
/// sample; its interval is empty too if s is at most rounding_of_logarithms. Throws Error, naming
/// the position from 1, if a value is not above zero.
std::optional<Estimate> geometric_mean(std::span<const double> values,
                                       double confidence = default_confidence);

/// Returns the geometric mean of values with these logarithms, such as ratios of times.
std::optional<Estimate> geometric_mean_of_logs(std::span<const double> logs,
                                               double confidence = default_confidence);

/// Returns the mean of a sample that is not empty. The second pass removes the rounding of the
/// first, and the range of long double keeps sums and squares of the largest doubles finite.
inline long double extended_mean(std::span<const double> values) {
  const auto n = static_cast<long double>(values.size());
  const long double first = std::accumulate(values.begin(), values.end(), 0.0L) / n;
  long double remainder = 0.0L;
  for (const double value : values) {
    remainder += value - first;
  }
  return first + remainder / n;
}

}  // namespace foveola::analysis
