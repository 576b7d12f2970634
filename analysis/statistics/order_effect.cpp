#include "analysis/statistics/order_effect.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace foveola::analysis {
namespace {

/// The index of the value's participant, or of its condition.
using Grouping = std::function<std::size_t(const OrderedValue&)>;

struct Group {
  double n = 0.0;
  long double position = 0.0L;
  long double value = 0.0L;
};

/// Subtracts the mean of each group from its values; returns the largest of these means.
double take_out_means(std::vector<OrderedValue>& values, const Grouping& group_of) {
  std::map<std::size_t, Group> sums;
  for (const OrderedValue& value : values) {
    Group& sum = sums[group_of(value)];
    sum.n += 1.0;
    sum.position += value.position;
    sum.value += value.value;
  }
  double largest = 0.0;
  for (OrderedValue& value : values) {
    const Group& sum = sums.at(group_of(value));
    const auto position = static_cast<double>(sum.position / sum.n);
    const auto mean_value = static_cast<double>(sum.value / sum.n);
    value.position -= position;
    value.value -= mean_value;
    largest = std::max({largest, std::abs(position), std::abs(mean_value)});
  }
  return largest;
}

/// The residuals of an additive model of participants and conditions, whose means are taken out in
/// turn until none is left: at once without missing cells, else in a few rounds.
std::vector<OrderedValue> residuals_of(std::vector<OrderedValue> values) {
  constexpr int most_rounds = 1000;
  constexpr double rounding = 1e-15;
  const Grouping participant = [](const OrderedValue& value) { return value.participant; };
  const Grouping condition = [](const OrderedValue& value) { return value.condition; };
  for (int round = 0; round < most_rounds; ++round) {
    const double taken = take_out_means(values, participant);
    if (std::max(taken, take_out_means(values, condition)) <= rounding) {
      break;
    }
  }
  return values;
}

struct Slope {
  long double squares = 0.0L;   ///< Sum of squares of the residual positions.
  long double products = 0.0L;  ///< Sum of their products with the residual values.
};

}  // namespace

std::optional<TTest> order_effect(const std::vector<OrderedValue>& values, double confidence) {
  constexpr long double rounding = 1e-18L;
  std::map<std::size_t, Slope> participants;
  for (const OrderedValue& residual : residuals_of(values)) {
    Slope& own = participants[residual.participant];
    own.squares += static_cast<long double>(residual.position) * residual.position;
    own.products += static_cast<long double>(residual.position) * residual.value;
  }
  std::vector<double> slopes;
  for (const auto& [participant, own] : participants) {
    if (own.squares > rounding) {
      slopes.push_back(static_cast<double>(own.products / own.squares));
    }
  }
  return one_sample_t(slopes, 0.0, confidence);
}

}  // namespace foveola::analysis
