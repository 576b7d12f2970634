// How evenly the orders of a study's participants came out.
#pragma once

#include <vector>

#include "study/design/plan.h"

namespace foveola::study {

/// One row for each method or scene, in the protocol's order; as many columns.
using Counts = std::vector<std::vector<int>>;

/// Of test trials only. How often ...
struct Balance {
  Counts method_at;                  ///< [method][position in a scene], over all scenes
  std::vector<Counts> method_at_in;  ///< [scene][method][position]
  Counts method_after;               ///< [method][the one before it in the same scene]
  Counts scene_at;                   ///< [scene][position]
  Counts scene_after;                ///< [scene][the one before it]
};

/// The plans must be of the protocol.
Balance balance_of(const Protocol& protocol, const std::vector<Plan>& plans);

/// The largest count less the smallest.
int largest_difference(const Counts& counts);

/// Likewise of counts of what comes after what: nothing comes after itself.
int largest_difference_after(const Counts& counts);

}  // namespace foveola::study
