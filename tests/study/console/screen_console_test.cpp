#include "study/console/screen_console.h"

#include <cstdio>

#include <unistd.h>

#include "tests/at_terminal.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

using test::AtTerminal;

/// Shows a session until it is asked to quit; answers each line by saying it.
int run_until_quit() {
  LineWriter output(STDOUT_FILENO);
  const std::unique_ptr<ScreenConsole> console = ScreenConsole::open(output);
  if (console == nullptr) {
    return 3;
  }
  console->show({.participant = "P42", .now = "rating"});
  while (true) {
    for (const std::string& line : console->take_commands()) {
      if (line == "quit") {
        return 0;
      }
      console->say("asked for: " + line);
    }
    ::usleep(1000);
  }
}

TEST(ScreenConsole, ShowsTheSessionAndTakesKeys) {
  AtTerminal terminal("xterm", run_until_quit);
  terminal.wait_for("Foveola, participant P42");
  terminal.wait_for("rating");
  terminal.type("note it rings \xc3\xbc\r");
  terminal.wait_for("asked for: note it rings \xc3\xbc");
  terminal.type("exclude P42 dark");
  terminal.wait_for("> exclude P42 dark_");
  terminal.type("\x1b");
  terminal.type("pause\r");
  terminal.wait_for("asked for: pause");
  terminal.type("quit\r");
  EXPECT_THAT(terminal.all_seen(), Not(HasSubstr("asked for: exclude")));
}

// By xterm's manual ("Bracketed Paste Mode"): between ESC [ 200 ~ and ESC [ 201 ~, once ESC [ ?2004
// h asked for it.
TEST(ScreenConsole, WhatIsPastedIsANoteAtMost) {
  const auto paste = [](const std::string& text) { return "\x1b[200~" + text + "\x1b[201~"; };
  AtTerminal terminal("xterm", run_until_quit);
  terminal.wait_for("\x1b[?2004h");
  terminal.wait_for("rating");
  terminal.type(paste("withdraw P42\r"));
  terminal.type("\r");
  terminal.wait_for("paste only notes");
  terminal.type("withdraw " + paste("P42") + "\r");
  terminal.type(paste("pause\nquit\n"));
  terminal.type("\x1b");
  terminal.type("note " + paste("it\rrings") + "\r");
  terminal.wait_for("asked for: note it rings");
  terminal.type("quit\r");
  const std::string seen = terminal.all_seen();
  EXPECT_THAT(seen, Not(HasSubstr("asked for: withdraw")));
  EXPECT_THAT(seen, Not(HasSubstr("asked for: pause")));
  EXPECT_THAT(seen, HasSubstr("\x1b[?2004l"));
}

TEST(ScreenConsole, NeitherCtrlSNorCtrlZHoldsItUp) {
  AtTerminal terminal("xterm", run_until_quit);
  terminal.wait_for("rating");
  terminal.type("\x13\x1apause\r");
  terminal.wait_for("asked for: pause");
}

TEST(ScreenConsole, LeavesTheTerminalWithAllThatWasSaid) {
  AtTerminal terminal("xterm", run_until_quit);
  terminal.wait_for("rating");
  terminal.type("pause\rquit\r");
  constexpr const char* leaves_alternate_screen = "\x1b[?1049l";
  const std::string seen = terminal.all_seen();
  const std::size_t left = seen.rfind(leaves_alternate_screen);
  ASSERT_NE(left, std::string::npos);
  EXPECT_THAT(seen.substr(left), EndsWith("asked for: pause\r\n"));
}

TEST(ScreenConsole, ATerminalThatCannotBePaintedOnHasNone) {
  for (const char* const kind : {"dumb", "unheard-of"}) {
    AtTerminal terminal(kind, [] { return run_until_quit() == 3 ? 0 : 1; });
    EXPECT_EQ(terminal.wait_without_reading(), 0) << kind;
  }
}

TEST(ScreenConsole, ATerminalThatTakesNothingDoesNotHoldItUp) {
  AtTerminal terminal("xterm", [] {
    LineWriter output(STDOUT_FILENO);
    const std::unique_ptr<ScreenConsole> console = ScreenConsole::open(output);
    for (int i = 0; i < 100; ++i) {
      console->say(std::string(80 * 24, static_cast<char>('a' + i % 26)));
      ::usleep(20'000);
    }
    return 0;
  });
  EXPECT_EQ(terminal.wait_without_reading(), 0);
}

TEST(ScreenConsole, WhereThereIsNoTerminalThereIsNone) {
  // Standard input is made a file, as it is where nobody types.
  const int input = ::dup(STDIN_FILENO);
  ASSERT_NE(std::freopen("/dev/null", "r", stdin), nullptr);
  LineWriter output(STDERR_FILENO);
  EXPECT_EQ(ScreenConsole::open(output), nullptr);
  if (input >= 0) {
    ::dup2(input, STDIN_FILENO);
    ::close(input);
  }
}

}  // namespace
}  // namespace foveola::study
