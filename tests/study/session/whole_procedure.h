// A small procedure with every kind of step, and a session that goes straight through it.
#pragma once

#include <string>
#include <vector>

#include "study/session/session.h"

namespace foveola::study {

constexpr Nanoseconds at(int milliseconds) { return std::chrono::milliseconds(milliseconds); }

/// Consent, a questionnaire, up to 2 validations, 2 presses, 2 trials with one object and 2 marks,
/// a debriefing. Trials are rated on a scale of 1 to 5, and by words if one likes.
Procedure whole_procedure();

/// From the start to the end. The first trial's are [6, 12).
std::vector<Event> all_events();

/// From the start until the first trial is to be rated.
std::vector<Event> events_of_first_trial();

/// "StopRendering", "AskForObject", ...
std::vector<std::string> names_of(const std::vector<Effect>& effects);

}  // namespace foveola::study
