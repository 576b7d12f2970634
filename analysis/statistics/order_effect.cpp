#include "analysis/statistics/order_effect.h"

#include <map>
#include <utility>

#include "analysis/statistics/additive_fit.h"

namespace foveola::analysis {
namespace {

/// The additive fit of what `quantity` is of each value.
AdditiveFit fit_of(const std::vector<OrderedValue>& values, double OrderedValue::* quantity) {
  std::vector<TrialValue> trials;
  trials.reserve(values.size());
  for (const OrderedValue& value : values) {
    trials.push_back({value.participant, value.condition, value.*quantity});
  }
  return AdditiveFit(std::move(trials));
}

struct Slope {
  long double squares = 0.0L;   ///< Sum of squares of the residual positions.
  long double products = 0.0L;  ///< Sum of their products with the residual values.
};

}  // namespace

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
  // Two participants' residuals are each other's negative, and so their slopes are equal.
  constexpr std::size_t fewest = 3;
  return slopes.size() < fewest ? std::nullopt : one_sample_t(slopes, 0.0, confidence);
}

}  // namespace foveola::analysis
