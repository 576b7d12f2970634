#include "analysis/statistics/rank_tests.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include <boost/math/distributions/chi_squared.hpp>

#include "analysis/statistics/correlation.h"
#include "analysis/statistics/distributions.h"

namespace foveola::analysis {
namespace {

double walsh_average(double a, double b) { return 0.5 * a + 0.5 * b; }

/// Returns the number of Walsh averages of the sorted values that are at most `bound`.
std::uint64_t averages_up_to(const std::vector<double>& sorted, double bound) {
  std::uint64_t count = 0;
  std::size_t end = sorted.size();
  for (std::size_t i = 0; i < end; ++i) {
    while (end > i && walsh_average(sorted[i], sorted[end - 1]) > bound) {
      --end;
    }
    count += end - i;
  }
  return count;
}

/// Maps doubles to integers of the same order.
std::int64_t place_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}

double value_at(std::int64_t place) {
  return std::bit_cast<double>(place >= 0 ? place
                                          : std::numeric_limits<std::int64_t>::min() - place);
}

/// Returns the `rank`th smallest Walsh average, from 1: the smallest double with this many at most
/// it.
double ranked_average(const std::vector<double>& sorted, std::uint64_t rank) {
  std::int64_t low = place_of(sorted.front());
  std::int64_t high = place_of(sorted.back());
  while (low < high) {
    const std::int64_t middle = std::midpoint(low, high);  // rounds towards low
    if (averages_up_to(sorted, value_at(middle)) >= rank) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return value_at(low);
}

/// Returns the smallest rank sum with cumulative probability of at least `tail`; 0 if even the
/// minimum has it.
std::uint64_t rank_sum_quantile(std::size_t n, double tail) {
  if (n > largest_exact_signed_rank) {
    const auto count = static_cast<double>(n);
    const double mean = count * (count + 1.0) / 4.0;
    const double deviation = std::sqrt(mean * (2.0 * count + 1.0) / 6.0);
    const double z = normal_two_sided_quantile(1.0 - 2.0 * tail);
    return static_cast<std::uint64_t>(std::max(0.0, std::ceil(mean - z * deviation - 0.5)));
  }
  std::vector<std::size_t> ranks(n);
  std::iota(ranks.begin(), ranks.end(), std::size_t{1});
  double probability = 0.0;
  std::uint64_t sum = 0;
  for (const double of_sum : rank_sum_distribution(ranks)) {
    probability += of_sum;
    if (probability >= tail) {
      break;
    }
    ++sum;
  }
  return sum;
}

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
  std::ranges::sort(doubled_ranks);
  return doubled_ranks;
}

/// Returns the probability of a sum of signed ranks that is at most this one.
double exact_tail(const std::vector<double>& probability, double sum) {
  return std::accumulate(probability.begin(), probability.begin() + std::lround(2.0 * sum) + 1,
                         0.0);
}

/// Returns the distance of a rank sum from its mean in standard deviations. The variance of the sum
/// of positive ranks is a quarter of the sum of squared ranks, which equals the formulas corrected
/// for ties and zeros.
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

// Works with probabilities, since counts would exceed the range of a double.
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

std::optional<FriedmanTest> friedman(const RepeatedMeasures& data) {
  if (data.participants < 2 || data.conditions < 2) {
    return std::nullopt;
  }
  const auto n = static_cast<double>(data.participants);
  const auto k = static_cast<double>(data.conditions);
  std::vector<double> rank_sums(data.conditions, 0.0);
  double ties = 0.0;
  for (std::size_t participant = 0; participant < data.participants; ++participant) {
    const Ranks ranks = rank(data.of(participant));
    ties += ranks.tie_correction;
    for (std::size_t condition = 0; condition < data.conditions; ++condition) {
      rank_sums[condition] += ranks.ranks[condition];
    }
  }
  const double scale = n * k * (k + 1.0) - ties / (k - 1.0);
  if (scale <= 0.0) {
    return std::nullopt;
  }
  double squares = 0.0;
  for (const double sum : rank_sums) {
    const double deviation = sum - n * (k + 1.0) / 2.0;
    squares += deviation * deviation;
  }
  FriedmanTest test;
  test.participants = data.participants;
  test.conditions = data.conditions;
  test.chi_squared = 12.0 * squares / scale;
  test.degrees_of_freedom = k - 1.0;
  const boost::math::chi_squared distribution(test.degrees_of_freedom);
  test.p = boost::math::cdf(boost::math::complement(distribution, test.chi_squared));
  test.kendalls_w = test.chi_squared / (n * (k - 1.0));
  return test;
}

std::optional<PseudoMedian> pseudo_median(std::span<const double> values, double confidence) {
  assert(confidence > 0.0 && confidence < 1.0);
  if (values.empty()) {
    return std::nullopt;
  }
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const std::uint64_t averages =
      static_cast<std::uint64_t>(sorted.size()) * (sorted.size() + 1) / 2;
  PseudoMedian result;
  result.n = sorted.size();
  result.value = walsh_average(ranked_average(sorted, (averages + 1) / 2),
                               ranked_average(sorted, averages / 2 + 1));
  const std::uint64_t lowest = rank_sum_quantile(sorted.size(), 0.5 * (1.0 - confidence));
  if (lowest > 0) {
    result.interval = {ranked_average(sorted, lowest),
                       ranked_average(sorted, averages + 1 - lowest)};
  }
  return result;
}

}  // namespace foveola::analysis
