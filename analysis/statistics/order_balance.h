// Balance of orders: whether methods come first, second and so on as often as chance would have it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace foveola::analysis {

/// How often each method had each position, [method][position], over blocks in each of which every
/// method has a position of its own: each row and each column sums to the number of blocks.
using PositionCounts = std::vector<std::vector<std::size_t>>;

struct OrderBalance {
  std::size_t blocks = 0;
  std::size_t fewest = 0;  ///< The smallest of the counts.
  std::size_t most = 0;    ///< The largest of the counts.
  double chi_squared = 0.0;
  double degrees_of_freedom = 0.0;
  double p = 0.0;  ///< The probability that random orders are at least as unbalanced.
};

/// Tests whether each block's order was drawn from all permutations alike, independently of the
/// other blocks. With b blocks of k methods a count has the expectation b / k and the variance
/// b (k - 1) / k^2 rather than the b / k of free counts, so (k - 1) / k times Pearson's sum of
/// (O - E)^2 / E has the expectation (k - 1)^2 and is chi-squared with so many degrees of freedom
/// (Anderson 1959, "Use of contingency tables in the analysis of consumer preference studies",
/// Biometrics 15). Empty with fewer than two methods or without blocks.
std::optional<OrderBalance> order_balance(const PositionCounts& counts);

}  // namespace foveola::analysis
