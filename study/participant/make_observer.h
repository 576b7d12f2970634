// Makes the participant of a simulated session.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "study/design/plan.h"
#include "study/participant/injected_effect.h"
#include "study/participant/simulated_participant.h"

namespace foveola::study {

/// A member of the population, with the injected effect if there is one. `seed` determines the
/// person, `row` is the number of the study's participant, from 0 on, `plan` is the session's.
std::unique_ptr<SimulatedObserver> make_observer(const Population& population,
                                                 const std::optional<InjectedEffect>& effect,
                                                 SceneKnowledge knowledge, std::uint64_t seed,
                                                 int row, const Plan& plan);

}  // namespace foveola::study
