// A computer whose clock is set, and which sleeps, in the midst of a session.
#include <filesystem>
#include <fstream>

#include "study/record/maintenance.h"
#include "tests/end_to_end/stepped_clock.h"
#include "tests/end_to_end/study_run.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

class RunBeforeClocks : public StudyRun {
 protected:
  RunBeforeClocks() {
    step({});
    participant_.set_environment("STEPPED_CLOCK", steps_);
    participant_.set_environment("LD_PRELOAD", STEPPED_CLOCK_LIBRARY);
  }

  void step(const ClockSteps& steps) const {
    std::fstream file(steps_, std::ios::binary | std::ios::in | std::ios::out);
    file.write(reinterpret_cast<const char*>(&steps), sizeof steps);
  }

  void begin_trial() {
    participant_.write_protocol(one_trial_keys, short_look);
    participant_.begin();
    participant_.begin_trials();
    participant_.answer_page("space");  // ready
    EXPECT_EQ(participant_.wait_for_page(), "marking");
  }

  void end_by_another_attempt(const std::string& note) {
    participant_.program().wait_for("Note: " + note);
    time_trial();
    rate("3");
    end_by_enter();
    EXPECT_THAT(participant_.ask("SELECT attempt, outcome FROM attempt ORDER BY attempt"),
                ElementsAre("1|retimed", "2|rated"));
    EXPECT_THAT(participant_.ask("SELECT text FROM note"), ElementsAre(note));
    const study::Verification verified = study::verify_study(participant_.database());
    EXPECT_TRUE(verified.faults.empty()) << verified.faults.front().what;
    EXPECT_THAT(verified.warnings, ElementsAre(FieldsAre("P1", HasSubstr(note))));
  }

  const fs::path steps_ = participant_.folder().write("steps", std::string(sizeof(ClockSteps), 0));
};

TEST_F(RunBeforeClocks, AClockThatIsSetInATrialIsNotedAndTheTrialTimedAgain) {
  begin_trial();
  step({.set_by_s = 5L * 3600});
  end_by_another_attempt("the computer's clock was set forward by 5 h 00 m while the session ran");
}

TEST_F(RunBeforeClocks, ASleepInATrialIsNotedAndTheTrialTimedAgain) {
  begin_trial();
  step({.asleep_s = 120});
  end_by_another_attempt("the computer slept for 2 m 00 s while the session ran");
}

}  // namespace
}  // namespace foveola::test
