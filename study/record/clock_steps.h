// The wall clock of a record, which may be set while a session goes on: its times stand, since they
// are by a clock that nobody sets, but its dates are then in doubt.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/record/study_store.h"

namespace foveola::study {

/// "3 m 05 s", "2 h 10 m" or "3653 days" by which the second of two UTC times, as utc_now() writes
/// them, lies before the first. Empty if it does so by no more than a minute, which is what an
/// honest correction of the clock may take, or if one of the texts is no such time.
std::optional<std::string> clock_set_back(const std::string& before, const std::string& after);

/// The note of a session with these events that goes on at `now`, a UTC time; empty if the clock
/// was not set back since its last event.
std::optional<std::string> note_of_clock(const std::vector<LoggedEvent>& events,
                                         const std::string& now);

/// Whether it is such a note.
bool is_note_of_clock(const std::string& note);

}  // namespace foveola::study
