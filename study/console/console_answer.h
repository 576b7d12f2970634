// What a line of the experimenter's console leads to.
#pragma once

#include <optional>
#include <string>

#include "study/session/session.h"

namespace foveola::study {

/// At most one of these.
struct ConsoleAnswer {
  std::string reply;           ///< what the experimenter reads; may be several lines
  std::optional<Event> event;  ///< an event for the session, which may refuse it
  bool quits = false;
};

/// state: the session's, on the disk or not. An empty line has none of the three.
ConsoleAnswer answer_to(const std::string& line, const SessionState& state,
                        const Procedure& procedure, const Plan& plan);

}  // namespace foveola::study
