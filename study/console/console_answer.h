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

/// Where a session is that a line is about.
struct AskedSession {
  const std::string& participant;  ///< the code, without which no line ends the session
  const SessionState& state;       ///< on the disk or not
  const Procedure& procedure;
  const Plan& plan;
};

/// An empty line has none of the three.
ConsoleAnswer answer_to(const std::string& line, const AskedSession& session);

}  // namespace foveola::study
