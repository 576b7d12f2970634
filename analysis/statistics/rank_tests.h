// Rank tests within participants: Wilcoxon's and Friedman's, and Hodges and Lehmann's estimate.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.h"
#include "analysis/statistics/repeated_measures.h"

namespace foveola::analysis {

/// Handling of differences that are exactly zero.
enum class ZeroRule {
  drop,   ///< They are left out before ranking (Wilcoxon 1945, and R's wilcox.test).
  pratt,  ///< They take the lowest ranks, which are then left out (Pratt 1959).
};

struct SignedRankTest {
  std::size_t n = 0;      ///< Number of differences that are not zero.
  std::size_t zeros = 0;  ///< Number of differences that are zero.
  double w_plus = 0.0;    ///< Sum of the ranks of positive differences.
  double w_minus = 0.0;   ///< Sum of the ranks of negative differences.
  double p = 0.0;         ///< Two-sided.
  double p_above = 0.0;   ///< One-sided: small if the differences lie above zero.
  bool exact = false;
  /// The matched-pairs rank-biserial correlation (Kerby 2014): (w_plus - w_minus) over their sum;
  /// 1 if all differences are positive.
  double rank_biserial = 0.0;
};

/// Maximum number of nonzero differences for an exact P-value, with or without ties: the
/// distribution of rank sums over all signs, by dynamic programming. Above, it is the normal
/// approximation with the variance corrected for ties and the continuity correction.
inline constexpr std::size_t largest_exact_signed_rank = 200;

/// Returns the probability of each sum of positive ranks, from 0 to that of all `ranks`, with
/// equally probable signs.
std::vector<double> rank_sum_distribution(const std::vector<std::size_t>& ranks);

/// Tests whether differences are symmetric around zero. Empty if all are zero or there are none.
/// Two differences are tied if their absolute values are the same number, so callers must round
/// computed values.
std::optional<SignedRankTest> signed_rank(std::span<const double> differences,
                                          ZeroRule zeros = ZeroRule::drop,
                                          std::size_t largest_exact = largest_exact_signed_rank);

struct FriedmanTest {
  std::size_t participants = 0;
  std::size_t conditions = 0;
  double chi_squared = 0.0;  ///< Corrected for ties within participants.
  double degrees_of_freedom = 0.0;
  double p = 0.0;           ///< From the chi-squared approximation.
  double kendalls_w = 0.0;  ///< Agreement of the participants, 0 to 1.
};

/// Tests whether the participants' rankings agree. Empty with fewer than two participants or two
/// conditions, or if every participant's values are all equal.
std::optional<FriedmanTest> friedman(const RepeatedMeasures& data);

struct PseudoMedian {
  std::size_t n = 0;
  double value = 0.0;  ///< Median of all Walsh averages (x[i] + x[j]) / 2 with i <= j.
  /// Two Walsh averages that cover the population's value with at least the given confidence
  /// (Hollander and Wolfe 1973, 3.4): the inversion of the signed-rank test, by its exact
  /// distribution without ties up to largest_exact_signed_rank values, by the normal approximation
  /// above. Conservative with ties. Empty if there is no such interval: at 95 %, with fewer than
  /// six values.
  std::optional<Interval> interval;
};

/// Returns Hodges and Lehmann's estimate. All values are finite; zeros count like any other. Takes
/// O(n log n), without listing the averages. Empty without values.
std::optional<PseudoMedian> pseudo_median(std::span<const double> values,
                                          double confidence = default_confidence);

}  // namespace foveola::analysis
