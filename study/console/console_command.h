// Parses the experimenter's typed commands, and answers them.
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
  std::string code;  ///< the participant's code, in commands that end a session
  std::string text;  ///< a note's text, or the reason of an exclusion
};

/// Parses a line. Empty if its command is unknown, or lacks its code or text.
std::optional<ConsoleCommand> parse_console_line(std::string_view line);

/// Returns the usage, as "exclude CODE REASON", of a line's command; empty if it is unknown.
std::string console_usage(std::string_view line);

/// Returns the words of all commands, on one line.
std::string console_words();

/// Returns a line per command.
std::string console_help();

struct ConsoleAnswer {
  std::string reply;           ///< text for the experimenter; may be several lines
  std::optional<Event> event;  ///< event for the session, which may refuse it
  bool quits = false;
};

struct AskedSession {
  const std::string& participant;  ///< the code that commands which end the session must name
  const SessionState& state;       ///< including events that are not durable yet
  const Procedure& procedure;
  const Plan& plan;
};

/// Answers a line. The answer to an empty line is empty.
ConsoleAnswer answer_to(const std::string& line, const AskedSession& session);

}  // namespace foveola::study
