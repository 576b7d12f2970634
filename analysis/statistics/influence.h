// Influence: how much of an estimate hangs on a single participant.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// What an estimate becomes when each participant in turn is left out. Participants are indices
/// into the values given.
struct LeaveOneOut {
  Interval estimates;            ///< The smallest and the largest estimate.
  std::size_t without_low = 0;   ///< Without this participant the estimate is the smallest.
  std::size_t without_high = 0;  ///< Without this participant the estimate is the largest.
};

/// Of `estimate`, which takes the values of the others. Empty with fewer than two values.
std::optional<LeaveOneOut> leave_one_out(
    std::span<const double> values, const std::function<double(std::span<const double>)>& estimate);

}  // namespace foveola::analysis
