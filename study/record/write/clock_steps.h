// Notes of the computer's clocks: the wall clock may be set, and the computer may sleep, while a
// session runs. A record's times stand, since they are by a clock that nobody sets, but its dates
// are then in doubt.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "study/record/write/study_store.h"

namespace foveola::study {

/// "3 m 05 s", "2 h 10 m" or "3653 days" by which the second of two UTC times, as utc_now() writes
/// them, lies before the first. Empty if it does so by no more than a minute, which is what an
/// honest correction of the clock may take, or if one of the texts is no such time.
std::optional<std::string> clock_set_back(const std::string& before, const std::string& after);

/// The note of a session with these events that goes on at `now`, a UTC time; empty if the clock
/// was not set back since its last event.
std::optional<std::string> note_of_clock(const std::vector<LoggedEvent>& events,
                                         const std::string& now);

/// "the computer's clock was set forward by 5 h 00 m while the session ran"; back by a negative
/// step.
std::string note_of_clock_step(Nanoseconds step);

/// "the computer slept for 2 m 00 s while the session ran".
std::string note_of_sleep(Nanoseconds duration);

/// Whether it is one of these two.
bool is_note_of_running_session(const std::string& note);

/// Whether it is any note of this page.
bool is_note_of_clock(const std::string& note);

}  // namespace foveola::study
