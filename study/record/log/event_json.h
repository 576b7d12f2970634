// An event as the text that the log keeps of it, and back.
#pragma once

#include <string>

#include "study/session/session.h"

namespace foveola::study {

/// The event's values as a JSON object on one line: the log's payload. Invalid Unicode is
/// replaced.
std::string payload_of(const Event& event);

/// The event of which the log holds this type and payload. Throws std::invalid_argument if there is
/// none.
Event event_from(const std::string& type, const std::string& payload);

}  // namespace foveola::study
