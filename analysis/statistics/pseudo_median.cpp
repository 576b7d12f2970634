#include "analysis/statistics/pseudo_median.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "analysis/statistics/normal.h"
#include "analysis/statistics/wilcoxon.h"

namespace foveola::analysis {
namespace {

double walsh_average(double a, double b) { return 0.5 * a + 0.5 * b; }

/// How many Walsh averages of the sorted values are at most `bound`.
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

/// Doubles as integers of the same order.
std::int64_t place_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}

double value_at(std::int64_t place) {
  return std::bit_cast<double>(place >= 0 ? place
                                          : std::numeric_limits<std::int64_t>::min() - place);
}

/// The Walsh average that is the `rank`th smallest, from 1: the smallest double that as many are at
/// most.
double ranked_average(const std::vector<double>& sorted, std::uint64_t rank) {
  std::int64_t low = place_of(sorted.front());
  std::int64_t high = place_of(sorted.back());
  while (low < high) {
    const std::int64_t middle = std::midpoint(low, high);  // towards low
    if (averages_up_to(sorted, value_at(middle)) >= rank) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return value_at(low);
}

/// The smallest rank sum that sums up to it have a probability of at least `tail`; 0 if even the
/// smallest sum has.
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

}  // namespace

std::optional<PseudoMedian> pseudo_median(std::span<const double> values, double confidence) {
  assert(confidence > 0.0 && confidence < 1.0);
  if (values.empty()) {
    return std::nullopt;
  }
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
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
