#include "analysis/statistics/correlation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "analysis/statistics/distributions.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

bool is_constant(std::span<const double> values) {
  const auto [low, high] = std::ranges::minmax_element(values);
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

/// Ranks are multiples of 1/2: twice a rank is a whole number.
std::vector<int> doubled_ranks(std::span<const double> values) {
  return transformed(rank(values).ranks,
                     [&](const double rank) { return static_cast<int>(std::lround(2.0 * rank)); });
}

/// The correlation grows with the sum of products of ranks, the only part that depends on their
/// order. Orders that differ only among equal ranks are counted once; all have equal multiplicity.
double exact_spearman_p(std::span<const double> x, std::span<const double> y) {
  const std::vector<int> x_ranks = doubled_ranks(x);
  std::vector<int> y_ranks = doubled_ranks(y);
  const auto products = [&] {
    return std::inner_product(x_ranks.begin(), x_ranks.end(), y_ranks.begin(), 0);
  };
  const int observed = products();
  std::ranges::sort(y_ranks);
  std::uint64_t orders = 0;
  std::uint64_t at_most = 0;
  std::uint64_t at_least = 0;
  do {
    const int sum = products();
    ++orders;
    at_most += sum <= observed ? 1 : 0;
    at_least += sum >= observed ? 1 : 0;
  } while (std::next_permutation(y_ranks.begin(), y_ranks.end()));
  const auto tail = static_cast<double>(std::min(at_most, at_least));
  return std::min(1.0, 2.0 * tail / static_cast<double>(orders));
}

}  // namespace

std::optional<Correlation> spearman(std::span<const double> x, std::span<const double> y,
                                    double confidence, std::size_t largest_exact) {
  std::optional<Correlation> result = pearson(rank(x).ranks, rank(y).ranks, confidence);
  if (result && result->n <= largest_exact) {
    result->exact = true;
    result->p = exact_spearman_p(x, y);
  }
  if (result && result->interval) {
    const double error =
        std::sqrt((1.0 + result->r * result->r / 2.0) / (static_cast<double>(result->n) - 3.0));
    result->interval = fisher_interval(result->r, normal_two_sided_quantile(confidence) * error);
  }
  return result;
}

std::vector<double> without_rounding(std::vector<double> values) {
  constexpr double step = 1e12;
  for (double& value : values) {
    value = std::round(value * step) / step;
  }
  return values;
}

Ranks rank(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  Ranks result{std::vector<double>(values.size()), 0.0};
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] == values[order[first]]) {
      ++end;
    }
    for (std::size_t i = first; i < end; ++i) {
      result.ranks[order[i]] = (static_cast<double>(first) + static_cast<double>(end) + 1.0) / 2.0;
    }
    const auto ties = static_cast<double>(end - first);
    result.tie_correction += ties * ties * ties - ties;
    first = end;
  }
  return result;
}

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
