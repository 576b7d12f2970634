// Sessions on other equipment than they, or those before them, had.

#include "study/record/maintenance.h"
#include "tests/end_to_end/study_run.h"
#include "tests/matchers.h"

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
  // What it ran on is in the record, at its beginning and at each resume.
  EXPECT_THAT(participant_.ask("SELECT (devices ->> '$.machine.threads') || ' ' ||"
                               " (devices ->> '$.machine.windows') FROM session"),
              ElementsAre("1 X11"));
  EXPECT_THAT(participant_.ask("SELECT text FROM note WHERE text LIKE 'goes on with {%'"),
              ElementsAre(HasSubstr("\"threads\":1")));
  std::vector<std::string> warnings;
  for (const study::RecordFault& warning : study::verify_study(participant_.database()).warnings) {
    warnings.push_back(warning.what);
  }
  EXPECT_THAT(warnings, Contains(HasSubstr("pixels: 640 x 480 in P1; 480 x 360 in P1")));
}

TEST_F(ChangedSetup, IsRefusedWhereTheProtocolAsksForTheSame) {
  participant_.write_protocol(one_trial_keys,
                              std::string("[preflight]\nsame_display = true\n") + short_look);
  begin_and_quit({});
  EXPECT_THAT(refused("P2", {}).errors, HasSubstr("pixels 480 x 360 (P1: 640 x 480)"));
  participant_.seat("P2");
  participant_.set_window("480x360");
  begin_and_quit({"--despite-changes"});
  EXPECT_THAT(participant_.ask("SELECT text FROM note WHERE text LIKE 'despite changes: %'"),
              ElementsAre(HasSubstr("pixels 480 x 360 (P1: 640 x 480)")));
}

}  // namespace
}  // namespace foveola::test
