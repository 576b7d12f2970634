// The balance of the orders of a study's participants.
#pragma once

#include <vector>

#include "study/design/plan.h"

namespace foveola::study {

/// One row for each method or scene, in the protocol's order; as many columns.
using Counts = std::vector<std::vector<int>>;

/// How often methods and scenes came at each position and after each other, in test trials only.
struct Balance {
  Counts method_at;                  ///< [method][position in a scene], over all scenes.
  std::vector<Counts> method_at_in;  ///< [scene][method][position]
  Counts method_after;               ///< [method][the one before it in the same scene]
  Counts scene_at;                   ///< [scene][position]
  Counts scene_after;                ///< [scene][the one before it]
};

/// The plans must be of the protocol.
Balance balance_of(const Protocol& protocol, const std::vector<Plan>& plans);

/// The largest count less the smallest.
int largest_difference(const Counts& counts);

/// The largest count less the smallest of what comes after what, without the diagonal, since
/// nothing comes after itself.
int largest_difference_after(const Counts& counts);

}  // namespace foveola::study
