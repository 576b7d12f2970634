#include "study/console/console_answer.h"

#include <stdexcept>

#include "study/console/console_command.h"
#include "study/console/console_words.h"

namespace foveola::study {

ConsoleAnswer answer_to(const std::string& line, const SessionState& state,
                        const Procedure& procedure, const Plan& plan) {
  const std::optional<ConsoleCommand> command = parse_console_line(line);
  if (!command) {
    return {.reply = line.empty() ? "" : "What is '" + line + "'? help says what there is."};
  }
  switch (command->action) {
    case ConsoleAction::state:
      return {.reply = words_for(state, procedure, plan)};
    case ConsoleAction::next:
      return {.reply = words_for_next(state, procedure, plan)};
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
    case ConsoleAction::quit:
      return {.quits = true};
    case ConsoleAction::help:
      return {.reply = console_help()};
  }
  throw std::logic_error("a console command that nobody answers");
}

}  // namespace foveola::study
