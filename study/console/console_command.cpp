#include "study/console/console_command.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace foveola::study {
namespace {

struct CommandWord {
  std::string_view word;
  ConsoleAction action;
  std::string_view argument;  ///< empty: it takes none
  std::string_view help;
};

constexpr std::array words = {
    CommandWord{"state", ConsoleAction::state, "", "where the session is"},
    CommandWord{"next", ConsoleAction::next, "", "what comes then"},
    CommandWord{"note", ConsoleAction::note, "TEXT", "keeps a note in the record"},
    CommandWord{"pause", ConsoleAction::pause, "",
                "a trial that has begun is timed again after it"},
    CommandWord{"resume", ConsoleAction::resume, "", "after a pause"},
    CommandWord{"retime", ConsoleAction::retime, "", "the timing failed: times the method again"},
    CommandWord{"exclude", ConsoleAction::exclude, "REASON", "ends the session; its data stay"},
    CommandWord{"withdraw", ConsoleAction::withdraw, "", "the participant stops taking part"},
    CommandWord{"quit", ConsoleAction::quit, "", "interrupts; --resume goes on later"},
    CommandWord{"help", ConsoleAction::help, "", "these lines"},
};

/// The end of `words` if it is none of them.
const CommandWord* known_word(std::string_view word) {
  return std::find_if(words.begin(), words.end(),
                      [&](const CommandWord& one) { return one.word == word; });
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

}  // namespace

std::optional<ConsoleCommand> parse_console_line(std::string_view line) {
  const std::string_view command = trimmed(line);
  const std::size_t gap = std::min(command.find_first_of(" \t"), command.size());
  const std::string_view word = command.substr(0, gap);
  const std::string_view text = trimmed(command.substr(gap));
  const auto* const known = known_word(word);
  const bool is_whole = known != words.end() && known->argument.empty() == text.empty();
  return is_whole
             ? std::optional(ConsoleCommand{.action = known->action, .text = std::string(text)})
             : std::nullopt;
}

std::string console_help() {
  std::string help;
  for (const CommandWord& one : words) {
    help += fmt::format("  {:<16}{}\n", fmt::format("{} {}", one.word, one.argument), one.help);
  }
  return help;
}

}  // namespace foveola::study
