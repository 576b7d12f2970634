#include "study/console/console_command.h"

#include <gmock/gmock.h>

namespace foveola::study {
namespace {

using ::testing::HasSubstr;

TEST(ConsoleCommand, KnowsItsCommands) {
  const auto action = [](const char* line) {
    const std::optional<ConsoleCommand> command = parse_console_line(line);
    return command ? std::optional(command->action) : std::nullopt;
  };
  EXPECT_EQ(action("state"), ConsoleAction::state);
  EXPECT_EQ(action("next"), ConsoleAction::next);
  EXPECT_EQ(action("  pause \r"), ConsoleAction::pause);
  EXPECT_EQ(action("resume"), ConsoleAction::resume);
  EXPECT_EQ(action("retime"), ConsoleAction::retime);
  EXPECT_EQ(action("withdraw"), ConsoleAction::withdraw);
  EXPECT_EQ(action("quit"), ConsoleAction::quit);
  EXPECT_EQ(action("help"), ConsoleAction::help);
  EXPECT_EQ(action("Withdraw?"), std::nullopt);
  EXPECT_EQ(action(""), std::nullopt);
}

TEST(ConsoleCommand, NotesAndReasonsKeepTheirWords) {
  const std::optional<ConsoleCommand> note = parse_console_line("note  the phone rang, twice ");
  ASSERT_TRUE(note);
  EXPECT_EQ(note->action, ConsoleAction::note);
  EXPECT_EQ(note->text, "the phone rang, twice");
  EXPECT_EQ(parse_console_line("exclude glasses")->text, "glasses");
}

TEST(ConsoleCommand, ASlipEndsNoSession) {
  EXPECT_FALSE(parse_console_line("note"));
  EXPECT_FALSE(parse_console_line("exclude"));
  EXPECT_FALSE(parse_console_line("withdraw P3"));
  EXPECT_FALSE(parse_console_line("quit now"));
}

TEST(ConsoleCommand, HelpNamesEveryCommand) {
  for (const char* word : {"state", "next", "note TEXT", "pause", "resume", "retime",
                           "exclude REASON", "withdraw", "quit", "help"}) {
    EXPECT_THAT(console_help(), HasSubstr(word));
  }
}

}  // namespace
}  // namespace foveola::study
