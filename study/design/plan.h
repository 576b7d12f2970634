// Who sees what in which order.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace foveola::study {

/// One method in one scene.
struct PlannedTrial {
  std::string scene;
  std::string method;
  int scene_position = 0;   ///< 0 is the first scene
  int method_position = 0;  ///< 0 is the first method within the scene
};

/// A session's trials in their order.
using Plan = std::vector<PlannedTrial>;

/// The published design: scenes in random order for each participant, methods in random order
/// within each scene. A function of its arguments alone, on every platform.
Plan random_plan(const Protocol& protocol, std::uint64_t seed, int participant_index);

}  // namespace foveola::study
