#include "analysis/statistics/logarithms.h"

#include <cmath>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola::analysis {

std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> logs;
  logs.reserve(values.size());
  for (const double value : values) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      throw Error(fmt::format("value {} of {}", logs.size() + 1, values.size()),
                  fmt::format("is {}, which has no logarithm", value),
                  "a geometric mean needs values above zero");
    }
    logs.push_back(std::log(value));
  }
  return logs;
}

Interval exp_of(const Interval& logs) { return {std::exp(logs.low), std::exp(logs.high)}; }

}  // namespace foveola::analysis
