// A session that is cut off in mid-trial ends with a line on what is safe and how to go on, and it
// goes on.
#include <csignal>
#include <filesystem>
#include <string>

#include <sys/wait.h>

#include "study/record/maintain/maintenance.h"
#include "tests/at_terminal.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/end_to_end/small_disk.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

class CutOffRun : public StudyRun {
 protected:
  /// Until the first mark was made.
  void begin_trial() {
    participant_.write_protocol(one_trial_keys, short_look);
    participant_.begin();
    participant_.begin_trials();
    participant_.answer_page("space");  // ready
    participant_.answer_page("space");
    participant_.program().wait_for("outline was marked");
  }

  void write_more_than_a_journal_keeps_free() {
    participant_.program().type_line("note " + std::string(2'000'000, 'x'));
  }

  /// Which says what is safe and how to go on.
  void expect_end_with_one_line() {
    EXPECT_EQ(participant_.program().wait_for_end(), 1);
    const std::string said = participant_.program().said();
    const std::size_t line = said.find("foveola: error: ");
    ASSERT_NE(line, std::string::npos) << said;
    EXPECT_THAT(said.substr(line), AllOf(HasSubstr("the session of P1 was interrupted"),
                                         HasSubstr("what P1 did up to then"),
                                         HasSubstr("repeat the command with --resume")));
    EXPECT_EQ(said.find('\n', line), said.size() - 1) << said;
  }

  void go_on_to_the_end() {
    participant_.begin({"--resume"});
    time_trial();
    rate("3");
    end_by_enter();
    participant_.expect_no_fault();
    EXPECT_THAT(participant_.ask("SELECT attempt, outcome FROM attempt ORDER BY attempt"),
                ElementsAre("1|interrupted", "2|rated"));
  }
};

TEST_F(CutOffRun, AClosedTerminalInterruptsIt) {
  begin_trial();
  constexpr int interrupted = 130;
  participant_.program().kill(SIGHUP);
  EXPECT_EQ(participant_.program().wait_for_end(), interrupted);
  EXPECT_THAT(participant_.program().said(), HasSubstr("repeat the command with --resume"));
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("interrupted"));
  go_on_to_the_end();
}

TEST_F(CutOffRun, ATerminalThatIsClosedTakesNothingAlong) {
  participant_.write_protocol(one_trial_keys, short_look);
  AtTerminal terminal("xterm", participant_.at_terminal());
  terminal.wait_for("Press Enter here to begin");
  terminal.type("\r");
  terminal.wait_for("next key");
  const int status = terminal.close_and_wait();
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("interrupted"));
}

TEST_F(CutOffRun, AFullDiskEndsItWithOneLineUntilThereIsRoom) {
  if (const std::string refusal = refusal_of_own_mounts(); !refusal.empty()) {
    GTEST_SKIP() << refusal;
  }
  const SmallDisk disk(participant_.folder() / "disk");
  participant_.keep_study_in(disk.folder());
  begin_trial();
  disk.fill();
  write_more_than_a_journal_keeps_free();
  expect_end_with_one_line();
  disk.make_room();
  go_on_to_the_end();
}

TEST_F(CutOffRun, ADiskThatIsFullAtTheEndCostsNothingButTheBackup) {
  if (const std::string refusal = refusal_of_own_mounts(); !refusal.empty()) {
    GTEST_SKIP() << refusal;
  }
  const SmallDisk disk(participant_.folder() / "disk");
  participant_.keep_study_in(disk.folder());
  begin_trial();
  participant_.answer_page("space");
  participant_.wait_for_page();
  rate("3");
  EXPECT_EQ(participant_.wait_for_page(), "completed");
  disk.fill();
  participant_.type("Return");
  EXPECT_EQ(participant_.program().wait_for_end(), 1);
  EXPECT_THAT(participant_.program().said(),
              AllOf(HasSubstr("all that P1 did is in "), HasSubstr("but its backup failed: "),
                    HasSubstr("mend that, then run foveola study backup")));
  disk.make_room();
  participant_.expect_no_fault();
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("completed"));
}

}  // namespace
}  // namespace foveola::test
