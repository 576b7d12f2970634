// Makes the participant of a simulated session.
#pragma once

#include <memory>
#include <optional>

#include "study/participant/injected_effect.h"
#include "study/participant/observed_session.h"
#include "study/participant/simulated_participant.h"

namespace foveola::study {

/// A member of the population, with the injected effect if there is one.
std::unique_ptr<SimulatedObserver> make_observer(const Population& population,
                                                 const std::optional<InjectedEffect>& effect,
                                                 SceneKnowledge knowledge,
                                                 const ObservedSession& session);

}  // namespace foveola::study
