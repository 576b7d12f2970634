// Influence: how much of a result hangs on a single participant.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"
#include "analysis/statistics/repeated_measures.h"

namespace foveola::analysis {

/// What an estimate and its P-value become when each participant in turn is left out. Participants
/// are indices into the values given.
struct LeaveOneOut {
  Interval estimates;            ///< The smallest and the largest estimate.
  std::size_t without_low = 0;   ///< Without this participant the estimate is the smallest.
  std::size_t without_high = 0;  ///< Without this participant the estimate is the largest.
  /// The smallest and the largest P-value; empty where the test is not defined without somebody.
  std::optional<Interval> p;
};

/// Of the mean log ratio over participants, and ratio_t. Empty with fewer than two participants.
std::optional<LeaveOneOut> leave_one_out(std::span<const double> log_ratios);

/// Of the mean log ratio of the crossed model, and its test, over participants. Empty with fewer
/// than three participants or two scenes.
std::optional<LeaveOneOut> leave_one_out(const RepeatedMeasures& log_ratios);

}  // namespace foveola::analysis
