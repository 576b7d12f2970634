#include "analysis/statistics/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "analysis/statistics/normal.h"
#include "analysis/statistics/ranks.h"

namespace foveola::analysis {

namespace {

/// Ranks are multiples of 1/2: twice a rank is a whole number.
std::vector<int> doubled_ranks(std::span<const double> values) {
  std::vector<int> doubled;
  for (const double rank : rank(values).ranks) {
    doubled.push_back(static_cast<int>(std::lround(2.0 * rank)));
  }
  return doubled;
}

/// The correlation grows with the sum of products of ranks, which alone changes with their order.
/// Orders that differ only among equal ranks are counted once, and all the same number of times.
double exact_spearman_p(std::span<const double> x, std::span<const double> y) {
  const std::vector<int> x_ranks = doubled_ranks(x);
  std::vector<int> y_ranks = doubled_ranks(y);
  const auto products = [&] {
    return std::inner_product(x_ranks.begin(), x_ranks.end(), y_ranks.begin(), 0);
  };
  const int observed = products();
  std::sort(y_ranks.begin(), y_ranks.end());
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

}  // namespace foveola::analysis
