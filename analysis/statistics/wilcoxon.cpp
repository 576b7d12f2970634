#include "analysis/statistics/wilcoxon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "analysis/statistics/normal.h"
#include "analysis/statistics/ranks.h"

namespace foveola::analysis {
namespace {

struct SignedRanks {
  std::vector<double> positive;
  std::vector<double> negative;
  std::size_t zeros = 0;
};

SignedRanks rank_signed(std::span<const double> differences, ZeroRule zero_rule) {
  std::vector<double> kept;
  std::vector<double> sizes;
  SignedRanks result;
  for (const double difference : differences) {
    result.zeros += difference == 0.0 ? 1 : 0;
    if (difference != 0.0 || zero_rule == ZeroRule::pratt) {
      kept.push_back(difference);
      sizes.push_back(std::abs(difference));
    }
  }
  const Ranks ranks = rank(sizes);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] != 0.0) {
      (kept[i] > 0.0 ? result.positive : result.negative).push_back(ranks.ranks[i]);
    }
  }
  return result;
}

/// Ranks are multiples of 1/2: twice a rank is a whole number.
std::vector<std::size_t> doubled(const SignedRanks& ranks) {
  std::vector<std::size_t> doubled_ranks;
  for (const auto* part : {&ranks.positive, &ranks.negative}) {
    for (const double rank : *part) {
      doubled_ranks.push_back(static_cast<std::size_t>(std::lround(2.0 * rank)));
    }
  }
  std::sort(doubled_ranks.begin(), doubled_ranks.end());
  return doubled_ranks;
}

/// The probability of a sum of signed ranks that is at most this one.
double exact_tail(const std::vector<double>& probability, double sum) {
  return std::accumulate(probability.begin(), probability.begin() + std::lround(2.0 * sum) + 1,
                         0.0);
}

/// The distance of a rank sum from its mean in standard deviations. The variance of the sum of
/// positive ranks is a quarter of the sum of squared ranks, which says the same as the formulas
/// that correct for ties and zeros.
double standardized(const SignedRanks& ranks, double distance) {
  double squares = 0.0;
  for (const auto* part : {&ranks.positive, &ranks.negative}) {
    for (const double rank : *part) {
      squares += rank * rank;
    }
  }
  return distance / (0.5 * std::sqrt(squares));
}

void compute_p(const SignedRanks& ranks, SignedRankTest& test) {
  if (test.exact) {
    const std::vector<double> probability = rank_sum_distribution(doubled(ranks));
    test.p = std::min(1.0, 2.0 * exact_tail(probability, std::min(test.w_plus, test.w_minus)));
    test.p_above = std::min(1.0, exact_tail(probability, test.w_minus));
    return;
  }
  const double above = (test.w_plus - test.w_minus) / 2.0;
  test.p = normal_two_sided(standardized(ranks, std::max(0.0, std::abs(above) - 0.5)));
  test.p_above = normal_cdf(-standardized(ranks, above - 0.5));
}

}  // namespace

// Works with probabilities, since counts would leave the range of a double.
std::vector<double> rank_sum_distribution(const std::vector<std::size_t>& ranks) {
  const std::size_t total = std::accumulate(ranks.begin(), ranks.end(), std::size_t{0});
  std::vector<double> probability(total + 1, 0.0);
  probability[0] = 1.0;
  std::size_t reach = 0;
  for (const std::size_t rank : ranks) {
    reach += rank;
    for (std::size_t sum = reach + 1; sum-- > 0;) {
      const double with_rank = sum >= rank ? probability[sum - rank] : 0.0;
      probability[sum] = 0.5 * (probability[sum] + with_rank);
    }
  }
  return probability;
}

std::optional<SignedRankTest> signed_rank(std::span<const double> differences, ZeroRule zeros,
                                          std::size_t largest_exact) {
  const SignedRanks ranks = rank_signed(differences, zeros);
  SignedRankTest test;
  test.n = ranks.positive.size() + ranks.negative.size();
  test.zeros = ranks.zeros;
  if (test.n == 0) {
    return std::nullopt;
  }
  test.w_plus = std::accumulate(ranks.positive.begin(), ranks.positive.end(), 0.0);
  test.w_minus = std::accumulate(ranks.negative.begin(), ranks.negative.end(), 0.0);
  test.exact = test.n <= largest_exact;
  compute_p(ranks, test);
  test.rank_biserial = (test.w_plus - test.w_minus) / (test.w_plus + test.w_minus);
  return test;
}

}  // namespace foveola::analysis
