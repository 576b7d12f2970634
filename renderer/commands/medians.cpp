#include "renderer/commands/medians.h"

#include <algorithm>
#include <cmath>

namespace foveola {
namespace {

/// The largest number k such that the k-th smallest and the k-th largest of `count` values enclose
/// the true median with at least 95 % confidence; 0 if no two do.
std::size_t place_of_ends(std::size_t count) {
  constexpr double allowed_beyond_an_end = 0.025;
  double probability = std::pow(0.5, static_cast<double>(count));  // that k lie below the median
  double beyond = 0.0;                                             // that at most k do
  for (std::size_t k = 0; k < count; ++k) {
    beyond += probability;
    if (beyond > allowed_beyond_an_end) {
      return k;
    }
    probability *= static_cast<double>(count - k) / static_cast<double>(k + 1);
  }
  return count;
}

}  // namespace

Median median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  Median median{.value = values[values.size() / 2], .interval = {}};
  if (const std::size_t place = place_of_ends(values.size()); place > 0) {
    median.interval = {values[place - 1], values[values.size() - place]};
  }
  return median;
}

Median operator*(const Median& median, double factor) {
  Median product{.value = factor * median.value, .interval = {}};
  if (median.interval) {
    product.interval = {factor * median.interval->first, factor * median.interval->second};
  }
  return product;
}

Median operator/(double amount, const Median& median) {
  Median quotient{.value = amount / median.value, .interval = {}};
  if (median.interval) {
    quotient.interval = {amount / median.interval->second, amount / median.interval->first};
  }
  return quotient;
}

nlohmann::ordered_json json_of(const Median& median) {
  nlohmann::ordered_json json = {{"median", median.value}, {"low", nullptr}, {"high", nullptr}};
  if (median.interval) {
    json["low"] = median.interval->first;
    json["high"] = median.interval->second;
  }
  return json;
}

}  // namespace foveola
