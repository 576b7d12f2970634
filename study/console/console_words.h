// Describes a session for the experimenter: its events, its state, its next steps.
//
// Methods are named here, so participants must not see these texts.
#pragma once

#include <string>

#include "study/session/session.h"

namespace foveola::study {

/// Returns "outline was marked after 3.214 s." or "Note: the phone rang". after: the session's
/// state after the event.
std::string words_for(const Event& event, const SessionState& after, const Protocol& protocol);

/// Returns "marking, trial 3 of 15: arcade with fv, timing 1, attempt 1".
std::string words_for(const SessionState& state, const Procedure& procedure, const Plan& plan);

/// Returns the plan for an experimenter who is blind to the methods. Catch trials look like others.
Plan without_methods(Plan plan);

/// Returns a description of the step after the current one.
std::string words_for_next(const SessionState& state, const Procedure& procedure, const Plan& plan);

}  // namespace foveola::study
