// Windows that lose the keyboard, or are no longer seen, in a person's session.
#include <chrono>
#include <thread>

#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

using namespace std::chrono_literals;

/// By the name of the window manager; none: "".
class Managed : public StudyRun, public testing::WithParamInterface<const char*> {
 protected:
  Managed() {
    if (*GetParam() != '\0') {
      participant_.manage_windows(GetParam());
    }
  }
};

TEST_P(Managed, KeysThatGoElsewhereCostNoMark) {
  participant_.write_protocol(one_trial_keys, "[timing]\nmark_timeout_s = 4\nrating_s = 0.2\n");
  participant_.begin();
  RunningProgram& program = participant_.program();
  participant_.begin_trials();
  participant_.answer_page("space");  // ready
  EXPECT_EQ(participant_.wait_for_page(), "marking");
  participant_.focus_elsewhere();
  EXPECT_EQ(participant_.wait_for_page(), "paused");
  program.wait_for("window does not have the keyboard");
  participant_.type("space");
  std::this_thread::sleep_for(5s);  // longer than a mark may take
  program.type_line("resume");
  program.wait_for("not possible now: The participant's window does not have the keyboard");
  participant_.focus_window();
  program.wait_for("Note: the window has the keyboard again");
  participant_.type("Return");
  time_trial();
  rate("3");
  end_by_enter();

  EXPECT_THAT(participant_.ask("SELECT attempt, outcome FROM attempt ORDER BY attempt"),
              ElementsAre("1|paused", "2|rated"));
  EXPECT_THAT(participant_.ask("SELECT text FROM note"),
              Contains(StartsWith("the window lost the keyboard")));
  EXPECT_THAT(participant_.ask("SELECT * FROM mark WHERE censored = 1"), IsEmpty());
  participant_.expect_no_fault();
}

INSTANTIATE_TEST_SUITE_P(By, Managed, testing::Values("", "openbox", "twm"),
                         [](const testing::TestParamInfo<const char*>& info) {
                           return *info.param == '\0' ? "nobody" : info.param;
                         });

TEST_F(StudyRun, AWindowThatIsNotSeenPauses) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin();
  participant_.answer_page("Return");  // welcome
  participant_.wait_for_page();
  participant_.minimise();
  participant_.program().wait_for("Note: the window is hidden");
  participant_.program().wait_for("The session pauses.");
  participant_.quit();
}

}  // namespace
}  // namespace foveola::test
