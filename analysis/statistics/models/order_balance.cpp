#include "analysis/statistics/models/order_balance.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>
#include <utility>

#include <boost/math/distributions/chi_squared.hpp>

#include "analysis/statistics/models/additive_fit.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

/// Returns the additive fit of a member of each value.
AdditiveFit fit_of(const std::vector<OrderedValue>& values, double OrderedValue::* quantity) {
  std::vector<TrialValue> trials = transformed(values, [&](const OrderedValue& value) {
    return TrialValue{value.participant, value.condition, value.*quantity};
  });
  return AdditiveFit(std::move(trials));
}

struct Slope {
  long double squares = 0.0L;   ///< Sum of squares of the residual positions.
  long double products = 0.0L;  ///< Sum of their products with the residual values.
};

}  // namespace

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

std::optional<TTest> order_effect(const std::vector<OrderedValue>& values, double confidence) {
  constexpr long double rounding = 1e-18L;
  const AdditiveFit positions = fit_of(values, &OrderedValue::position);
  const AdditiveFit fit = fit_of(values, &OrderedValue::value);
  std::map<std::size_t, Slope> participants;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const long double position = positions.residual(i);
    Slope& own = participants[values[i].participant];
    own.squares += position * position;
    own.products += position * fit.residual(i);
  }
  std::vector<double> slopes;
  for (const auto& [participant, own] : participants) {
    if (own.squares > rounding) {
      slopes.push_back(static_cast<double>(own.products / own.squares));
    }
  }
  // Two participants' residuals are negatives of each other, so their slopes are equal.
  constexpr std::size_t fewest = 3;
  return slopes.size() < fewest ? std::nullopt : test_mean(slopes, 0.0, confidence);
}

}  // namespace foveola::analysis
