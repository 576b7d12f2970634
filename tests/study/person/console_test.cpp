#include "study/person/console.h"

#include <array>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/waiting.h"

namespace foveola::study {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Console, KnowsItsCommands) {
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

TEST(Console, NotesAndReasonsKeepTheirWords) {
  const std::optional<ConsoleCommand> note = parse_console_line("note  the phone rang, twice ");
  ASSERT_TRUE(note);
  EXPECT_EQ(note->action, ConsoleAction::note);
  EXPECT_EQ(note->text, "the phone rang, twice");
  EXPECT_EQ(parse_console_line("exclude glasses")->text, "glasses");
}

TEST(Console, ASlipEndsNoSession) {
  EXPECT_FALSE(parse_console_line("note"));
  EXPECT_FALSE(parse_console_line("exclude"));
  EXPECT_FALSE(parse_console_line("withdraw P3"));
  EXPECT_FALSE(parse_console_line("quit now"));
}

TEST(Console, HelpNamesEveryCommand) {
  for (const char* word : {"state", "next", "note TEXT", "pause", "resume", "retime",
                           "exclude REASON", "withdraw", "quit", "help"}) {
    EXPECT_THAT(console_help(), HasSubstr(word));
  }
}

/// All lines until there are `count`; throws std::runtime_error if there never are.
std::vector<std::string> wait_for_lines(ConsoleLines& console, std::size_t count) {
  std::vector<std::string> lines;
  foveola::test::wait_until("lines", [&] {
    for (std::string& line : console.take()) {
      lines.push_back(std::move(line));
    }
    return lines.size() >= count;
  });
  return lines;
}

TEST(Console, ReadsWholeLines) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  ConsoleLines console(pipe[0]);
  const std::string typed = "state\nnote a";
  ASSERT_EQ(::write(pipe[1], typed.data(), typed.size()), static_cast<ssize_t>(typed.size()));
  EXPECT_THAT(wait_for_lines(console, 1), ElementsAre("state"));
  ASSERT_EQ(::write(pipe[1], "bc\n", 3), 3);
  EXPECT_THAT(wait_for_lines(console, 1), ElementsAre("note abc"));
  ::close(pipe[1]);
  ::close(pipe[0]);
}

TEST(Console, DoesWithoutAnInput) {
  const int nothing = ::open("/dev/null", O_RDONLY);
  {
    ConsoleLines console(nothing);
    EXPECT_TRUE(console.take().empty());
  }
  ::close(nothing);
  ConsoleLines closed(nothing);
  EXPECT_TRUE(closed.take().empty());
}

}  // namespace
}  // namespace foveola::study
