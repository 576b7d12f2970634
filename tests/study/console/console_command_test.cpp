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
  EXPECT_EQ(action("withdraw P3"), ConsoleAction::withdraw);
  EXPECT_EQ(action("undo"), ConsoleAction::undo);
  EXPECT_EQ(action("quit"), ConsoleAction::quit);
  EXPECT_EQ(action("help"), ConsoleAction::help);
  EXPECT_EQ(action("Withdraw P3"), std::nullopt);
  EXPECT_EQ(action(""), std::nullopt);
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

TEST(ConsoleCommand, HelpNamesEveryCommand) {
  for (const std::string usage : {"state", "next", "note TEXT", "pause", "resume", "retime",
                                  "exclude CODE REASON", "withdraw CODE", "undo", "quit", "help"}) {
    EXPECT_THAT(console_help(), HasSubstr(usage));
    const std::string word = usage.substr(0, usage.find(' '));
    EXPECT_THAT(console_words(), HasSubstr(word));
    EXPECT_THAT(console_usage(word), HasSubstr(usage));
  }
  EXPECT_EQ(console_usage("lunch"), "");
  EXPECT_LT(console_words().size(), 80U) << "a line of the terminal";
}

}  // namespace
}  // namespace foveola::study
