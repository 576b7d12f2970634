// What a line of the experimenter's console leads to.
#pragma once

#include <optional>
#include <string>

#include "study/session/session.h"

namespace foveola::study {

/// At most one of these.
struct ConsoleAnswer {
  std::string told;            ///< to the experimenter; may be several lines
  std::optional<Event> event;  ///< of the session, to be tried
  bool quits = false;
};

/// state: the session's, on the disk or not. An empty line has none of the three.
ConsoleAnswer answer_to(const std::string& line, const SessionState& state,
                        const Procedure& procedure, const Plan& plan);

}  // namespace foveola::study
