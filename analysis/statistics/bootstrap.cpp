#include "analysis/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/distributions.h"
#include "analysis/statistics/logarithms.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

double plain_mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

std::vector<double> resampled_means(std::span<const double> values,
                                    const BootstrapSettings& settings) {
  Pcg32 generator(settings.seed);
  const auto n = static_cast<std::uint32_t>(values.size());
  std::vector<double> sample(values.size());
  std::vector<double> means;
  means.reserve(static_cast<std::size_t>(settings.resamples));
  for (int i = 0; i < settings.resamples; ++i) {
    std::generate(sample.begin(), sample.end(), [&] { return values[generator.below(n)]; });
    means.push_back(plain_mean(sample));
  }
  return means;
}

/// Returns the acceleration: a sixth of the skewness of the values' influence, with its sign.
double acceleration(std::span<const double> jackknife) {
  const long double center = extended_mean(jackknife);
  long double squares = 0.0L;
  long double cubes = 0.0L;
  for (const double value : jackknife) {
    const long double influence = center - value;
    squares += influence * influence;
    cubes += influence * influence * influence;
  }
  return squares > 0.0L ? static_cast<double>(cubes / (6.0L * squares * std::sqrt(squares))) : 0.0;
}

/// Returns the quantile of sorted replicates, interpolated on the normal scale.
double normal_scale_quantile(const std::vector<double>& sorted, double probability) {
  const auto steps = static_cast<double>(sorted.size()) + 1.0;
  const auto below = static_cast<std::size_t>(steps * probability);
  if (below == 0) {
    return sorted.front();
  }
  if (below >= sorted.size()) {
    return sorted.back();
  }
  const double low = normal_quantile(static_cast<double>(below) / steps);
  const double high = normal_quantile(static_cast<double>(below + 1) / steps);
  const double part = (normal_quantile(probability) - low) / (high - low);
  return sorted[below - 1] + part * (sorted[below] - sorted[below - 1]);
}

std::vector<double> means_without_each(std::span<const double> values) {
  const auto others = static_cast<long double>(values.size() - 1);
  const long double sum = extended_mean(values) * (others + 1.0L);
  return transformed(
      values, [&](const double value) { return static_cast<double>((sum - value) / others); });
}

}  // namespace

std::optional<Interval> bca_from_replicates(double observed, std::vector<double> replicates,
                                            std::span<const double> jackknife, double confidence) {
  const auto below =
      std::ranges::count_if(replicates, [&](double value) { return value < observed; });
  if (below == 0 || below == static_cast<std::ptrdiff_t>(replicates.size())) {
    return std::nullopt;
  }
  std::ranges::sort(replicates);
  const double bias =
      normal_quantile(static_cast<double>(below) / static_cast<double>(replicates.size()));
  const double skew = acceleration(jackknife);
  const auto end = [&](double z) {
    const double shifted = bias + z;
    return normal_scale_quantile(replicates, normal_cdf(bias + shifted / (1.0 - skew * shifted)));
  };
  const double z = normal_two_sided_quantile(confidence);
  return Interval{end(-z), end(z)};
}

std::optional<Interval> bca_geometric_mean(std::span<const double> values,
                                           const BootstrapSettings& settings) {
  const std::vector<double> logs = logarithms(values);
  if (logs.size() < min_for_bca) {
    return std::nullopt;
  }
  const std::optional<Interval> interval =
      bca_from_replicates(plain_mean(logs), resampled_means(logs, settings),
                          means_without_each(logs), settings.confidence);
  return interval ? std::optional(Interval{std::exp(interval->low), std::exp(interval->high)})
                  : std::nullopt;
}

}  // namespace foveola::analysis
