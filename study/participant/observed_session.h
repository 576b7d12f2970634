// What a simulated participant needs to know of a session.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/design/plan.h"

namespace foveola::study {

/// The session that a simulated participant takes part in.
struct ObservedSession {
  std::uint64_t seed = 0;  ///< Determines the person.
  int row = 0;             ///< Number of the study's participant; the first is 0.
  Plan plan;
  std::vector<std::string> marks;  ///< The ids of a trial's marks, in their order.
};

}  // namespace foveola::study
