// What the experimenter can ask for in the terminal, as a typed line, and what it leads to.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "study/session/session.h"

namespace foveola::study {

enum class ConsoleAction {
  state,
  next,
  note,
  pause,
  resume,
  retime,
  exclude,
  withdraw,
  undo,
  quit,
  help,
};

struct ConsoleCommand {
  ConsoleAction action = ConsoleAction::help;
  std::string code;  ///< the participant's, of what ends a session
  std::string text;  ///< a note's words, or the reason of an exclusion
};

/// Parses a line. Empty if it asks for nothing that is known, or lacks the code or text it needs.
std::optional<ConsoleCommand> parse_console_line(std::string_view line);

/// "exclude CODE REASON" for a line that begins with this word; empty for one of no known word.
std::string console_usage(std::string_view line);

/// The words of all commands, on one line.
std::string console_words();

/// A line for each command.
std::string console_help();

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
