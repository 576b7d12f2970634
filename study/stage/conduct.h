// How simulated participants take part, in virtual time and in real time alike.
#pragma once

#include <string>
#include <vector>

#include "study/participant/participant.h"
#include "study/protocol/protocol.h"
#include "study/stage/seeds.h"

namespace foveola::study {

/// They look this often. People integrate over about as long, and each look costs as much as
/// tracing several frames.
constexpr double glance_interval_s = 0.1;

/// Until a participant is ready for a trial: head and eye have turned to the object.
constexpr double settling_s = 1.0;

/// What they look for until they make this mark. Whoever makes one that nobody judges, at a drawn
/// time, keeps the eyes on the object as for its material.
Task task_of(const MarkEntry& mark);

/// The attempt at the trial that `state` is in, as the participant takes part in it.
Attempt attempt_at_trial(const SessionSeed& seed, const Protocol& protocol,
                         const Procedure& procedure, const Plan& plan, const SessionState& state);

/// The look at all targets of a validation in which `state` is.
inline Attempt attempt_at_validation(const SessionSeed& seed, const SessionState& state) {
  return {.conduct = step_seed(seed, SeedPurpose::conduct, state), .trials_before = 0};
}

/// The object of this name. Throws Error if the scene does not offer it any more.
const OfferedObject& object_named(const std::vector<OfferedObject>& offered,
                                  const std::string& name);

}  // namespace foveola::study
