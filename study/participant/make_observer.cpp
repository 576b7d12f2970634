#include "study/participant/make_observer.h"

#include <utility>

#include "study/participant/injected_effect_participant.h"

namespace foveola::study {

std::unique_ptr<SimulatedObserver> make_observer(const Population& population,
                                                 const std::optional<InjectedEffect>& effect,
                                                 SceneKnowledge knowledge, std::uint64_t seed,
                                                 int row, const Plan& plan) {
  SimulatedParticipant person(population, std::move(knowledge), seed);
  if (!effect) {
    return std::make_unique<SimulatedParticipant>(std::move(person));
  }
  return std::make_unique<InjectedEffectParticipant>(*effect, person, population.background, seed,
                                                     row, plan);
}

}  // namespace foveola::study
