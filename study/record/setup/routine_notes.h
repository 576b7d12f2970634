// The notes that the program writes as a matter of routine, which nobody needs to read before
// believing a session's data.
#pragma once

#include <string>

#include "renderer/base/vec.h"

namespace foveola::study {

/// The note of a session whose window has another size from here on.
std::string note_of_window_size(const IVec2& pixels);

/// Whether it is one of the devices or the amended protocol that a session goes on with, of the
/// program or the computer's clocks, which verify_study warns of, or of the window's size.
bool is_routine_note(const std::string& note);

}  // namespace foveola::study
