#include "analysis/statistics/order_balance.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include <boost/math/distributions/chi_squared.hpp>

namespace foveola::analysis {

std::optional<OrderBalance> order_balance(const PositionCounts& counts) {
  if (counts.size() < 2) {
    return std::nullopt;
  }
  OrderBalance balance;
  balance.blocks = std::accumulate(counts.front().begin(), counts.front().end(), std::size_t{0});
  if (balance.blocks == 0) {
    return std::nullopt;
  }
  const auto k = static_cast<double>(counts.size());
  const double expected = static_cast<double>(balance.blocks) / k;
  double pearson = 0.0;
  balance.fewest = balance.blocks;
  for (const std::vector<std::size_t>& row : counts) {
    assert(row.size() == counts.size());
    for (const std::size_t count : row) {
      const double deviation = static_cast<double>(count) - expected;
      pearson += deviation * deviation / expected;
      balance.fewest = std::min(balance.fewest, count);
      balance.most = std::max(balance.most, count);
    }
  }
  balance.chi_squared = (k - 1.0) / k * pearson;
  balance.degrees_of_freedom = (k - 1.0) * (k - 1.0);
  const boost::math::chi_squared distribution(balance.degrees_of_freedom);
  balance.p = boost::math::cdf(boost::math::complement(distribution, balance.chi_squared));
  return balance;
}

}  // namespace foveola::analysis
