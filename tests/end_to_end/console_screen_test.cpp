// The experimenter's console as a screen of the terminal, through a session.

#include "tests/at_terminal.h"
#include "tests/end_to_end/study_run.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

TEST_F(StudyRun, IsSeenAndSteeredOnOneScreen) {
  participant_.write_protocol(one_trial_keys, short_look);
  AtTerminal terminal("xterm", participant_.at_terminal());
  terminal.wait_for("Press Enter here to begin");
  EXPECT_THAT(terminal.seen(), AllOf(HasSubstr("disk"), Not(HasSubstr("next key"))))
      << "the table stands alone";
  EXPECT_THAT(participant_.ask("SELECT * FROM session"), IsEmpty()) << "nothing has begun";
  terminal.type("\r");
  terminal.wait_for("Foveola, participant P1");
  participant_.point_at(320, 240);
  terminal.wait_for("[Enter] begin");
  participant_.type("Return");
  terminal.wait_for("[Enter] choose it");
  participant_.type("Return");
  terminal.wait_for("ready to start, trial 1 of 1: hall with od");
  participant_.type("space");
  terminal.wait_for("[Space] outline");
  participant_.type("space");
  terminal.wait_for("outline was marked after");
  terminal.wait_for("[Space] material");
  terminal.type("The exit was dark\rpeople\r");
  terminal.wait_for("What is 'people'?");
  terminal.type("note it rings\r");
  terminal.wait_for("Note: it rings");
  terminal.type("pause\r");
  terminal.wait_for("paused, trial 1 of 1");
  terminal.type("quit\r");
  EXPECT_THAT(terminal.all_seen(), HasSubstr("give the same command with --resume"));
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("interrupted"));
  EXPECT_THAT(participant_.ask("SELECT text FROM note"), ElementsAre("it rings"));
}

}  // namespace
}  // namespace foveola::test
