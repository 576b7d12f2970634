#include "study/console/console_answer.h"

#include <stdexcept>

#include <fmt/format.h>

#include "study/console/console_command.h"
#include "study/console/console_words.h"

namespace foveola::study {
namespace {

std::string reply_to_unknown(const std::string& line) {
  const std::string usage = console_usage(line);
  if (line.empty() || usage.empty()) {
    return line.empty() ? "" : fmt::format("What is '{}'? help says what there is.", line);
  }
  return fmt::format("'{}' is not a whole command; type {}", line, usage);
}

}  // namespace

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
  throw std::logic_error("a console command that nobody answers");
}

}  // namespace foveola::study
