// Who takes part in a simulated session.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "study/design/plan.h"
#include "study/participant/injected_effect.h"
#include "study/participant/simulated_participant.h"

namespace foveola::study {

/// One of the population, or of it with an effect. seed: who. row: which of the study's
/// participants, from 0 on. plan: the session's.
std::unique_ptr<SimulatedObserver> make_observer(const Population& population,
                                                 const std::optional<InjectedEffect>& effect,
                                                 SceneKnowledge knowledge, std::uint64_t seed,
                                                 int row, const Plan& plan);

}  // namespace foveola::study
