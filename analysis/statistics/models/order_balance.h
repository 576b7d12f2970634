// Tests the balance of orders of methods, and changes of times along the session.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/statistics/paired_t.h"

namespace foveola::analysis {

/// Counts [method][position] over blocks in each of which every method has a position of its own:
/// each row and each column sums to the number of blocks.
using PositionCounts = std::vector<std::vector<std::size_t>>;

struct OrderBalance {
  std::size_t blocks = 0;
  std::size_t fewest = 0;  ///< Minimum of the counts.
  std::size_t most = 0;    ///< Maximum of the counts.
  double chi_squared = 0.0;
  double degrees_of_freedom = 0.0;
  double p = 0.0;  ///< Probability that random orders are at least as unbalanced.
};

/// Tests whether each block's order was drawn uniformly from all permutations, independently of the
/// other blocks. With b blocks of k methods a count has the expectation b / k and the variance b (k
/// - 1) / k^2 rather than the b / k of free counts. So (k - 1) / k times Pearson's sum of (O - E)^2
/// / E has the expectation (k - 1)^2 and is chi-squared with as many degrees of freedom (Anderson
/// 1959, "Use of contingency tables in the analysis of consumer preference studies", Biometrics
/// 15). Empty with fewer than two methods or without blocks.
std::optional<OrderBalance> order_balance(const PositionCounts& counts);

/// One value (the logarithm of a time) with its condition and position.
struct OrderedValue {
  std::size_t participant = 0;
  std::size_t condition = 0;  ///< Index of the scene and method together.
  double position = 0.0;      ///< In the session, or within the scene, from 0.
  double value = 0.0;
};

/// Tests the change of `value` with each step of position: the mean over participants of their own
/// least-squares slopes, from values and positions less the effects of participants and conditions
/// (the residuals of an additive model of both), so that neither is taken for an effect of order,
/// also with missing cells. The test is test_mean of the slopes. Participants whose positions do
/// not vary beyond their conditions' have no slope. Empty if test_mean is, and with fewer than
/// three slopes.
std::optional<TTest> order_effect(const std::vector<OrderedValue>& values,
                                  double confidence = default_confidence);

}  // namespace foveola::analysis
