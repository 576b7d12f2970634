// Counts how balanced the orders of a study's participants are.
#pragma once

#include <vector>

#include "study/design/plan.h"

namespace foveola::study {

/// One row per method or scene, in the protocol's order; as many columns.
using Counts = std::vector<std::vector<int>>;

/// Counts of positions and successions of methods and scenes, in test trials only.
struct Balance {
  Counts method_at;                  ///< [method][position in a scene], over all scenes.
  std::vector<Counts> method_at_in;  ///< [scene][method][position]
  Counts method_after;               ///< [method][previous method in the same scene]
  Counts scene_at;                   ///< [scene][position]
  Counts scene_after;                ///< [scene][previous scene]
};

/// Counts the plans, which must be of the protocol.
Balance balance_of(const Protocol& protocol, const std::vector<Plan>& plans);

/// Returns the maximum count less the minimum.
int largest_difference(const Counts& counts);

/// Returns the maximum count less the minimum, without the diagonal: nothing follows itself.
int largest_difference_after(const Counts& counts);

}  // namespace foveola::study
