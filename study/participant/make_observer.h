// Makes the participant of a simulated session.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/design/plan.h"
#include "study/participant/injected_effects/injected_effect.h"
#include "study/participant/simulated_participant.h"

namespace foveola::study {

/// The session that a simulated participant takes part in.
struct ObservedSession {
  std::uint64_t seed = 0;  ///< Determines the person.
  int row = 0;             ///< Number of the study's participant; the first is 0.
  Plan plan;
  std::vector<std::string> marks;  ///< The ids of a trial's marks, in their order.
};

/// Returns a member of the population, with the injected effect if there is one.
std::unique_ptr<Participant> make_observer(const Population& population,
                                           const std::optional<InjectedEffect>& effect,
                                           SceneKnowledge knowledge,
                                           const ObservedSession& session);

}  // namespace foveola::study
