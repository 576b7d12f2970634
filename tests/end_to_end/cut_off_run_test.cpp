// A session that is cut off in mid-trial ends with a line on what is safe and how to go on, and it
// goes on.
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// The program in a terminal of its own, which a test can close.
class InTerminal {
 public:
  InTerminal(const std::vector<std::string>& arguments, const fs::path& folder) {
    process_ = ::forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (process_ == 0) {
      ::setenv("FOVEOLA_RESOURCES", (folder / "share").c_str(), 1);
      ::setenv("FOVEOLA_SCENE_PATH", (folder / "real").c_str(), 1);
      ::setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
      std::vector<std::string> all = {FOVEOLA_PROGRAM};
      all.insert(all.end(), arguments.begin(), arguments.end());
      std::vector<char*> words;
      for (std::string& word : all) {
        words.push_back(word.data());
      }
      words.push_back(nullptr);
      ::execv(words[0], words.data());
      ::_exit(127);
    }
  }
  ~InTerminal() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
  }
  InTerminal(const InTerminal&) = delete;
  InTerminal& operator=(const InTerminal&) = delete;

  /// Until it has said `words`, or ends.
  void wait_for(const std::string& words) const {
    std::string said;
    std::array<char, 1024> bytes{};
    while (said.find(words) == std::string::npos) {
      const ssize_t count = ::read(terminal_, bytes.data(), bytes.size());
      ASSERT_GT(count, 0) << said;
      said.append(bytes.data(), static_cast<std::size_t>(count));
    }
  }

  /// As the window manager's cross does. Returns what waitpid says of the program's end.
  int close_and_wait() {
    ::close(terminal_);
    int status = 0;
    ::waitpid(std::exchange(process_, -1), &status, 0);
    return status;
  }

 private:
  int terminal_ = -1;
  pid_t process_ = -1;
};

TEST_F(CutOffRun, ATerminalThatIsClosedTakesNothingAlong) {
  participant_.write_protocol(one_trial_keys, short_look);
  InTerminal terminal({"study", "run", "keys", "--db", participant_.database().string(),
                       "--participant", "P1", "--window", "640x480"},
                      participant_.folder() / "");
  terminal.wait_for("Session time 0 is ");
  const int status = terminal.close_and_wait();
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("interrupted"));
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
