// What the experimenter can ask for in the terminal, as a typed line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

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

}  // namespace foveola::study
