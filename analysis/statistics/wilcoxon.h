// Wilcoxon's signed-rank test: differences within participants, without a shape for them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace foveola::analysis {

/// What becomes of differences that are exactly zero.
enum class ZeroRule {
  drop,   ///< they are left out before ranks are given (Wilcoxon 1945, and R's wilcox.test)
  pratt,  ///< they take the lowest ranks, which are then left out (Pratt 1959)
};

struct SignedRankTest {
  std::size_t n = 0;      ///< differences that are not zero
  std::size_t zeros = 0;  ///< differences that are
  double w_plus = 0.0;    ///< the sum of the ranks of positive differences
  double w_minus = 0.0;
  double p = 0.0;  ///< two-sided
  bool exact = false;
  /// The matched-pairs rank-biserial correlation (Kerby 2014): (w_plus - w_minus) over their sum;
  /// 1 if all differences are positive.
  double rank_biserial = 0.0;
};

/// Up to so many differences that are not zero the P-value is exact, whether or not there are ties:
/// the distribution of rank sums over all signs, by dynamic programming. Above, it is the normal
/// approximation with the variance corrected for ties and the continuity correction.
inline constexpr std::size_t largest_exact_signed_rank = 200;

/// How probable each sum of positive ranks is, from 0 to that of all `ranks`, when every sign is a
/// fair coin.
std::vector<double> rank_sum_distribution(const std::vector<std::size_t>& ranks);

/// Whether differences are symmetric around zero. Empty if all are zero or there are none. Two
/// differences are tied if their absolute values are the same number: round what was computed.
std::optional<SignedRankTest> signed_rank(std::span<const double> differences,
                                          ZeroRule zeros = ZeroRule::drop,
                                          std::size_t largest_exact = largest_exact_signed_rank);

/// The same of a[i] - b[i].
std::optional<SignedRankTest> signed_rank(std::span<const double> a, std::span<const double> b,
                                          ZeroRule zeros = ZeroRule::drop);

}  // namespace foveola::analysis
