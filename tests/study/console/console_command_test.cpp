#include "study/console/console_command.h"

#include <utility>

#include "tests/matchers.h"

namespace foveola::study {
namespace {

TEST(ConsoleCommand, KnowsItsCommands) {
  for (const auto& [line, action] :
       {std::pair("state", ConsoleAction::state), std::pair("next", ConsoleAction::next),
        std::pair("  pause \r", ConsoleAction::pause), std::pair("resume", ConsoleAction::resume),
        std::pair("retime", ConsoleAction::retime), std::pair("undo", ConsoleAction::undo),
        std::pair("withdraw P3", ConsoleAction::withdraw), std::pair("quit", ConsoleAction::quit),
        std::pair("help", ConsoleAction::help)}) {
    EXPECT_EQ(parse_console_line(line).value().action, action) << line;
  }
  EXPECT_FALSE(parse_console_line("Withdraw P3"));
  EXPECT_FALSE(parse_console_line(""));
}

TEST(ConsoleCommand, NotesAndReasonsKeepTheirWords) {
  const std::optional<ConsoleCommand> note = parse_console_line("note  the phone rang, twice ");
  ASSERT_TRUE(note);
  EXPECT_EQ(note->action, ConsoleAction::note);
  EXPECT_EQ(note->text, "the phone rang, twice");
  const std::optional<ConsoleCommand> exclusion =
      parse_console_line("exclude  P3 \t wears  glasses");
  ASSERT_TRUE(exclusion);
  EXPECT_EQ(exclusion->code, "P3");
  EXPECT_EQ(exclusion->text, "wears  glasses");
}

TEST(ConsoleCommand, ASlipEndsNoSession) {
  EXPECT_FALSE(parse_console_line("note"));
  EXPECT_FALSE(parse_console_line("exclude"));
  EXPECT_FALSE(parse_console_line("exclude P3"));
  EXPECT_FALSE(parse_console_line("withdraw"));
  EXPECT_FALSE(parse_console_line("withdraw P3 now"));
  EXPECT_FALSE(parse_console_line("undo it"));
  EXPECT_FALSE(parse_console_line("quit now"));
}

}  // namespace
}  // namespace foveola::study
