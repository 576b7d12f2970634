// A session in the experimenter's words: what happened, where it is, what comes.
//
// Methods are named here, and therefore nowhere near the participant.
#pragma once

#include <string>

#include "study/session/session.h"

namespace foveola::study {

/// "outline was marked after 3.214 s.", "Note: the phone rang". after: the session's state after
/// the event.
std::string words_for(const Event& event, const SessionState& after, const Protocol& protocol);

/// "marking, trial 3 of 15: arcade with fv, timing 1, attempt 1".
std::string words_for(const SessionState& state, const Procedure& procedure, const Plan& plan);

/// The plan as an experimenter may know it who is blind to the methods. Catch trials are as others.
Plan without_methods(Plan plan);

/// What comes after the step that the session is in.
std::string words_for_next(const SessionState& state, const Procedure& procedure, const Plan& plan);

}  // namespace foveola::study
