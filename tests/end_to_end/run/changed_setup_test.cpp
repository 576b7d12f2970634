// Sessions on other equipment than they, or those before them, had.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/end_to_end/small_disk.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

class ChangedSetup : public StudyRun {
 protected:
  void begin_and_quit(const std::vector<std::string>& options) {
    participant_.begin(options);
    participant_.wait_for_page();
    participant_.quit();
  }

  ProgramResult refused(const std::string& participant, std::vector<std::string> options) {
    options.insert(options.end(), {"--window", "480x360"});
    ProgramResult result = participant_.run_besides(participant, options);
    EXPECT_EQ(result.exit_code, 1);
    return result;
  }
};

TEST_F(ChangedSetup, ASessionIsContinuedAsItBegan) {
  participant_.write_protocol(one_trial_keys, short_look);
  begin_and_quit({});
  EXPECT_THAT(refused("P1", {"--resume"}).errors,
              AllOf(HasSubstr("would have other equipment"),
                    HasSubstr("pixels 480 x 360 (before: 640 x 480)")));
  EXPECT_THAT(refused("P1", {"--resume", "--pilot"}).errors, HasSubstr("continue without --pilot"));
  participant_.set_window("480x360");
  begin_and_quit({"--resume", "--despite-changes"});
  EXPECT_THAT(participant_.ask("SELECT text FROM note WHERE text LIKE 'despite changes: %'"),
              ElementsAre(HasSubstr("pixels 480 x 360 (before: 640 x 480)")));
  std::vector<std::string> warnings;
  for (const study::RecordFault& warning : study::verify_study(participant_.database()).warnings) {
    warnings.push_back(warning.what);
  }
  EXPECT_THAT(warnings, Contains(HasSubstr("pixels: 640 x 480 in P1; 480 x 360 in P1")));
}

/// The kernel's file of the first core's governor says what the test writes.
class RecordedMachine : public ChangedSetup {
 protected:
  void SetUp() override {
    if (const std::string refusal = refusal_of_own_mounts(); !refusal.empty()) {
      GTEST_SKIP() << refusal;
    }
    fs::create_directory(kernel_.emplace("/sys/devices/system/cpu/cpu0").folder() / "cpufreq");
  }

  void set_governor(const std::string& name) const {
    std::ofstream(kernel_->folder() / "cpufreq/scaling_governor") << name << '\n';
  }

  /// Of the devices in JSON that a query gives.
  Rows machine(const std::string& devices) const {
    return participant_.ask(
        "SELECT (d ->> '$.governor') || ' ' || (d ->> '$.keyboard_layout') || ' ' ||"
        " (d ->> '$.windows') || ' ' || (d ->> '$.threads')"
        " FROM (SELECT d -> '$.machine' AS d FROM (" +
        devices + "))");
  }

  std::optional<SmallDisk> kernel_;
};

TEST_F(RecordedMachine, AtTheBeginningAndAtEachResume) {
  participant_.write_protocol(one_trial_keys, short_look);
  set_governor("performance");
  begin_and_quit({});
  ASSERT_EQ(std::system("setxkbmap -layout de,ru -variant nodeadkeys,"), 0);
  set_governor("powersave");
  begin_and_quit({"--resume"});
  EXPECT_THAT(machine("SELECT devices AS d FROM session"), ElementsAre("performance us X11 1"));
  const std::string resumed =
      "SELECT substr(text, length('goes on with ') + 1) AS d FROM note"
      " WHERE text LIKE 'goes on with {%'";
  EXPECT_THAT(machine(resumed), ElementsAre("powersave de(nodeadkeys),ru X11 1"));

  const Rows commits = participant_.ask("SELECT d ->> '$.machine.commit' FROM (" + resumed +
                                        " UNION ALL SELECT devices FROM session)");
  ASSERT_EQ(commits.size(), 2U);
  EXPECT_EQ(commits[0], commits[1]);
  const fs::path repository = fs::path(FRONT_DOOR).parent_path();
  const auto git = [&](const std::vector<std::string>& arguments) {
    return run_program(joined({"git", "-C", repository}, arguments)).exit_code;
  };
  if (fs::exists(repository / ".git") && git({"rev-parse", "HEAD"}) == 0) {
    EXPECT_EQ(commits[0].size(), 12U);
    EXPECT_EQ(git({"merge-base", "--is-ancestor", commits[0], "HEAD"}), 0)
        << commits[0] << " is not HEAD or before it";
  }
}

TEST_F(ChangedSetup, IsRefusedWhereTheProtocolAsksForTheSame) {
  participant_.write_protocol(one_trial_keys,
                              std::string("[preflight]\nsame_display = true\n") + short_look);
  begin_and_quit({});
  EXPECT_THAT(refused("P2", {}).errors, HasSubstr("pixels 480 x 360 (P1: 640 x 480)"));
  participant_.seat("P2");
  participant_.set_window("480x360");
  begin_and_quit({"--despite-changes"});
  EXPECT_THAT(participant_.program().said(),
              HasSubstr("WARNING: other equipment: pixels 480 x 360 (P1: 640 x 480)."));
  EXPECT_THAT(participant_.ask("SELECT text FROM note WHERE text LIKE 'despite changes: %'"),
              ElementsAre(HasSubstr("pixels 480 x 360 (P1: 640 x 480)")));
}

}  // namespace
}  // namespace foveola::test
