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
  quit,
  help,
};

struct ConsoleCommand {
  ConsoleAction action = ConsoleAction::help;
  std::string text;  ///< a note's words, or the reason of an exclusion
};

/// What a line asks for. Empty if it asks for nothing that is known, or lacks the text it needs.
std::optional<ConsoleCommand> parse_console_line(std::string_view line);

/// A line for each command.
std::string console_help();

}  // namespace foveola::study
