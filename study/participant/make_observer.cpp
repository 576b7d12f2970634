#include "study/participant/make_observer.h"

#include <utility>

#include "study/participant/injected_effects/injected_effect_participant.h"

namespace foveola::study {

std::unique_ptr<Participant> make_observer(const Population& population,
                                           const std::optional<InjectedEffect>& effect,
                                           SceneKnowledge knowledge,
                                           const ObservedSession& session) {
  SimulatedParticipant person(population, std::move(knowledge), session.seed);
  if (!effect) {
    return std::make_unique<SimulatedParticipant>(std::move(person));
  }
  return std::make_unique<InjectedEffectParticipant>(*effect, person, population.background,
                                                     session);
}

}  // namespace foveola::study
