#include "study/console/console_command.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "study/console/console_words.h"

namespace foveola::study {
namespace {

std::string reply_to_unknown(const std::string& line) {
  const std::string usage = console_usage(line);
  if (line.empty() || usage.empty()) {
    return line.empty() ? "" : fmt::format("'{}' is not a command; type help for a list.", line);
  }
  return fmt::format("'{}' is incomplete; type {}", line, usage);
}

struct CommandWord {
  std::string_view word;
  ConsoleAction action;
  std::string_view argument;  ///< empty: the command takes none
  std::string_view help;

  bool takes_code() const { return argument.starts_with("CODE"); }
  bool takes_text() const { return argument.ends_with("TEXT") || argument.ends_with("REASON"); }
};

constexpr std::array words = {
    CommandWord{"state", ConsoleAction::state, "", "shows the session's state"},
    CommandWord{"next", ConsoleAction::next, "", "shows the next step"},
    CommandWord{"note", ConsoleAction::note, "TEXT", "keeps a note in the record"},
    CommandWord{"pause", ConsoleAction::pause, "", "a trial that has begun is retimed afterwards"},
    CommandWord{"resume", ConsoleAction::resume, "", "continues after a pause"},
    CommandWord{"retime", ConsoleAction::retime, "", "retimes the method after a failed timing"},
    CommandWord{"exclude", ConsoleAction::exclude, "CODE REASON",
                "ends the session; its data stay"},
    CommandWord{"withdraw", ConsoleAction::withdraw, "CODE",
                "ends the session: the participant stops taking part"},
    CommandWord{"undo", ConsoleAction::undo, "", "undoes the session's end"},
    CommandWord{"quit", ConsoleAction::quit, "",
                "interrupts the session; --resume continues it later"},
    CommandWord{"help", ConsoleAction::help, "", "shows these lines"},
};

/// Returns the end of the words if it is unknown.
const CommandWord* known_word(std::string_view word) {
  return std::ranges::find(words, word, &CommandWord::word);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(" \t"));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace

std::optional<ConsoleCommand> parse_console_line(std::string_view line) {
  std::string_view rest = line;
  const auto* const known = known_word(take_word(rest));
  if (known == words.end()) {
    return std::nullopt;
  }
  ConsoleCommand command{.action = known->action};
  if (known->takes_code()) {
    command.code = take_word(rest);
  }
  command.text = trimmed(rest);
  const bool is_whole =
      known->takes_code() != command.code.empty() && known->takes_text() != command.text.empty();
  return is_whole ? std::optional(std::move(command)) : std::nullopt;
}

std::string console_usage(std::string_view line) {
  const auto* const known = known_word(take_word(line));
  return known == words.end() ? "" : fmt::format("{} {}", known->word, known->argument);
}

std::string console_words() {
  std::string line;
  for (const CommandWord& one : words) {
    line += fmt::format("{}{}", line.empty() ? "" : "  ", one.word);
  }
  return line;
}

std::string console_help() {
  std::string help;
  for (const CommandWord& one : words) {
    help += fmt::format("  {:<21}{}\n", fmt::format("{} {}", one.word, one.argument), one.help);
  }
  return help;
}

ConsoleAnswer answer_to(const std::string& line, const AskedSession& session) {
  const std::optional<ConsoleCommand> command = parse_console_line(line);
  if (!command) {
    return {.reply = reply_to_unknown(line)};
  }
  if (!command->code.empty() && command->code != session.participant) {
    return {.reply = fmt::format("'{}' is not the participant of this session; type the code {}",
                                 command->code, session.participant)};
  }
  switch (command->action) {
    case ConsoleAction::state:
      return {.reply = words_for(session.state, session.procedure, session.plan)};
    case ConsoleAction::next:
      return {.reply = words_for_next(session.state, session.procedure, session.plan)};
    case ConsoleAction::note:
      return {.event = NoteWritten{command->text}};
    case ConsoleAction::pause:
      return {.event = PauseRequested{}};
    case ConsoleAction::resume:
      return {.event = Resumed{}};
    case ConsoleAction::retime:
      return {.event = RetimeRequested{}};
    case ConsoleAction::exclude:
      return {.event = Excluded{command->text}};
    case ConsoleAction::withdraw:
      return {.event = Withdrawn{}};
    case ConsoleAction::undo:
      return {.event = EndUndone{}};
    case ConsoleAction::quit:
      return {.quits = true};
    case ConsoleAction::help:
      return {.reply = console_help()};
  }
  throw std::logic_error("an unanswered console command");
}

}  // namespace foveola::study
