// Order and learning: whether times change along the session.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/statistics/paired_t.h"

namespace foveola::analysis {

/// One value (the logarithm of a time) with what was shown and when.
struct OrderedValue {
  std::size_t participant = 0;
  std::size_t condition = 0;  ///< Index of the scene and method together.
  double position = 0.0;      ///< In the session, or within the scene, from 0.
  double value = 0.0;
};

/// The change of `value` with each step of position: the mean over participants of each one's own
/// least-squares slope, from values and positions less what participants and conditions have on
/// average (the residuals of an additive model of both), so that neither is taken for an effect of
/// order, also where cells are missing. The test is one_sample_t of the slopes. Participants whose
/// positions do not vary beyond their conditions' have no slope. Empty where one_sample_t is, and
/// with fewer than three slopes.
std::optional<TTest> order_effect(const std::vector<OrderedValue>& values,
                                  double confidence = default_confidence);

}  // namespace foveola::analysis
