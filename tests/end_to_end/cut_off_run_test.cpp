// A session that is cut off in mid-trial ends with a line on what is safe and how to go on, and it
// goes on.
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "study/record/maintenance.h"
#include "tests/end_to_end/study_run.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class CutOffRun : public StudyRun {
 protected:
  /// Until the first mark was made.
  void begin_trial() {
    participant_.write_protocol(one_trial_keys, short_look);
    participant_.begin();
    participant_.answer_page("Return");  // welcome
    participant_.answer_page("Return");  // choosing
    participant_.answer_page("space");   // ready
    participant_.answer_page("space");
    participant_.program().wait_for("outline was marked");
  }

  void go_on_to_the_end() {
    participant_.begin({"--resume"});
    time_trial();
    rate("3");
    end_by_enter();
    const study::Verification verified = study::verify_study(participant_.database());
    EXPECT_TRUE(verified.faults.empty()) << verified.faults.front().what;
    EXPECT_THAT(participant_.ask("SELECT attempt, outcome FROM attempt ORDER BY attempt"),
                ElementsAre("1|interrupted", "2|rated"));
  }
};

TEST_F(CutOffRun, AClosedTerminalInterruptsIt) {
  begin_trial();
  constexpr int interrupted = 130;
  participant_.program().kill(SIGHUP);
  EXPECT_EQ(participant_.program().wait_for_end(), interrupted);
  EXPECT_THAT(participant_.program().said(), HasSubstr("give the same command with --resume"));
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("interrupted"));
  go_on_to_the_end();
}

/// No file may grow beyond the largest that the study has now.
void let_no_file_grow(pid_t process, const fs::path& study) {
  std::uintmax_t largest = 0;
  for (const char* const suffix : {"", "-wal"}) {
    largest = std::max(largest, fs::file_size(study.string() + suffix));
  }
  const rlimit limit{.rlim_cur = largest, .rlim_max = RLIM_INFINITY};
  ASSERT_EQ(::prlimit(process, RLIMIT_FSIZE, &limit, nullptr), 0);
}

TEST_F(CutOffRun, ADiskThatTakesNoMoreEndsItWithOneLine) {
  begin_trial();
  let_no_file_grow(participant_.program().process(), participant_.database());
  // More than fits into what a journal has kept free.
  participant_.program().type_line("note " + std::string(2'000'000, 'x'));
  EXPECT_EQ(participant_.program().wait_for_end(), 1);
  const std::string said = participant_.program().said();
  EXPECT_THAT(said.substr(said.find("foveola: error: ")),
              AllOf(HasSubstr("the session of P1 was cut off"), HasSubstr("what P1 did up to then"),
                    HasSubstr("give the same command with --resume")));
  EXPECT_EQ(said.find("foveola: error: "), said.rfind("foveola: error: "));
  go_on_to_the_end();
}

}  // namespace
}  // namespace foveola::test
