// Another terminal follows a session that goes on.
#include <algorithm>

#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

TEST_F(StudyRun, IsWatchedFromAnotherTerminal) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin();
  RunningProgram watcher({"study", "watch", participant_.database().string()});
  RunningProgram machine(
      {"study", "watch", participant_.database().string(), "--participant", "P1", "--json"});
  watcher.wait_for("The session begins.");
  EXPECT_THAT(
      watcher.wait_for("now "),
      HasSubstr("choosing an object, trial 1 of 1: hall with od, timing 1, attempt 1; then the "
                "session's end"));
  participant_.begin_trials();
  watcher.wait_for("The object Wall was chosen.");
  time_trial();
  watcher.wait_for("outline was marked after ");
  rate("3");
  end_by_enter();
  watcher.wait_for("The trial was rated.");
  EXPECT_EQ(watcher.wait_for_end(), 0) << "the session is over";
  EXPECT_EQ(machine.wait_for_end(), 0);
  EXPECT_THAT(machine.said(), AllOf(HasSubstr("\"event\":\"object_chosen\""),
                                    HasSubstr("\"phase\":\"completed\"")));
  participant_.expect_no_fault();
}

TEST_F(StudyRun, WhoIsBlindReadsNoMethodUntilTheSessionIsOver) {
  participant_.write_protocol("methods = [\"od\", \"fv\"]\nphases = [\"trials\"]\n", short_look);
  participant_.begin({"--blind"});
  RunningProgram watcher({"study", "watch", participant_.database().string()});
  watcher.wait_for("hall with a hidden method");
  participant_.answer_page("Return");  // welcome
  participant_.wait_for_page();
  participant_.program().type_line("state");
  participant_.program().wait_for("hall with a hidden method");
  participant_.quit();

  participant_.begin({"--resume"});
  participant_.program().type_line("next");
  participant_.program().wait_for("trial 2 of 2: hall with a hidden method");
  for (RunningProgram* program : {&watcher, &participant_.program()}) {
    const std::string said = program->said();
    const std::size_t begin = std::min(said.find("Session time 0"), said.size());
    EXPECT_EQ(said.find("with od", program == &watcher ? 0 : begin), std::string::npos) << said;
  }
  participant_.quit();
  EXPECT_THAT(
      participant_.ask("SELECT json_extract(devices, '$.experimenter_is_blind') FROM session"),
      ElementsAre("1"));
}

}  // namespace
}  // namespace foveola::test
