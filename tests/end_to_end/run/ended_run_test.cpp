// Sessions in the real window that end early, are gone on with, or do not begin.
#include <csignal>
#include <filesystem>

#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/end_to_end/study_rows.h"
#include "tests/end_to_end/tracker_profile.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

TEST_F(StudyRun, AParticipantMayStop) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin();
  participant_.begin_trials();
  participant_.answer_page("Escape");  // ready
  participant_.answer_page("BackSpace");
  participant_.wait_for_page();
  participant_.type_all({"y", "j", "BackSpace", "Return"});  // no, continue
  participant_.answer_page("BackSpace");
  participant_.wait_for_page();
  participant_.type_all({"Down", "Return"});
  end_by_enter();
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("withdrawn"));
}

TEST_F(StudyRun, WhatWasKilledGoesOn) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin();
  participant_.wait_for_page();
  participant_.program().kill(SIGKILL);
  participant_.program().wait_for_end();
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("choosing_object"));
  EXPECT_THAT(participant_.run_besides("P1", {}).errors, HasSubstr("unfinished session"));

  participant_.begin({"--resume"});
  EXPECT_EQ(participant_.wait_for_page(), "choosing_object");
  RunningProgram& program = participant_.program();
  program.type_line("withdraw");
  program.wait_for("type withdraw CODE");
  program.type_line("withdraw P11");
  program.wait_for("type the code P1");
  program.type_line("withdraw P1");
  program.wait_for("undo takes the end back");
  program.type_line("undo");
  program.wait_for("it is paused");
  program.type_line("resume");
  program.wait_for("The session continues");
  program.type_line("withdraw P1");
  program.wait_for("stopped taking part");
  participant_.quit();
  EXPECT_THAT(participant_.ask("SELECT type FROM event ORDER BY sequence"),
              ElementsAre("session_started", "interrupted", "note_written", "resumed", "withdrawn",
                          "end_undone", "resumed", "withdrawn"));
  EXPECT_THAT(
      participant_.run_besides("P1", {"--resume"}).errors,
      AllOf(HasSubstr("already has a withdrawn session"), HasSubstr("--undo-end undoes the end")));
}

TEST_F(StudyRun, AnEndIsUndoneByAnotherRunUntilTheNextEvent) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin();
  participant_.answer_page("Return");  // welcome
  EXPECT_EQ(participant_.wait_for_page(), "choosing_object");
  participant_.program().type_line("withdraw P1");
  participant_.program().wait_for("stopped taking part");
  participant_.quit();

  participant_.begin({"--resume", "--undo-end"});
  EXPECT_EQ(participant_.wait_for_page(), "choosing_object");
  participant_.type("Return");
  time_trial();
  rate("3");
  end_by_enter();
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("completed"));
  EXPECT_THAT(participant_.ask("SELECT type FROM event ORDER BY sequence LIMIT 5"),
              ElementsAre("session_started", "withdrawn", "end_undone", "note_written", "resumed"));
  participant_.expect_no_fault();
  EXPECT_EQ(participant_.replay().exit_code, 0);
  EXPECT_THAT(participant_.run_besides("P1", {"--resume", "--undo-end"}).errors,
              HasSubstr("already has a completed session"));
}

TEST_F(StudyRun, CodesThatDifferInCapitalLettersOnlyAreWarnedOf) {
  participant_.write_protocol("\nmethods = [\"od\", \"vp\"]\nphases = [\"trials\"]\n", short_look);
  const fs::path protocol = participant_.folder() / "share/protocols/keys.toml";
  write_file(protocol,
             replaced(read_file(protocol), "method_order = \"fixed\"", "method_order = \"latin\""));
  const std::string first = "P1";
  for (const char* code : {"P1", "p1"}) {
    participant_.seat(code);
    participant_.begin(code == first ? std::vector<std::string>{"--first-row", "1"}
                                     : std::vector<std::string>{});
    participant_.wait_for_page();
    participant_.quit();
    EXPECT_EQ(participant_.program().said().find("p1 is another participant than P1") !=
                  std::string::npos,
              std::string(code) == "p1");
  }
  // Two methods have two orders, which those who follow the first person have in turn.
  EXPECT_THAT(participant_.ask("SELECT design_row FROM session ORDER BY id"),
              ElementsAre("1", "0"));
}

TEST_F(StudyRun, TakesNobodysEyeForAPersons) {
  participant_.write_protocol(one_trial_keys, short_look);
  const std::string simulated =
      participant_.folder().write("nobody.toml", tracker_profile("simulated", 120));
  participant_.folder().write("gaze.csv", "time_ns,x,y,z,valid\n0,0,0,-1,1\n");
  const std::string recorded = participant_.folder().write(
      "former.toml", tracker_profile("recorded", 120) + "recording = \"gaze.csv\"\n");
  expect_one_line(participant_.run_besides("P2", {"--tracker", simulated}), 1,
                  "is simulated; name the connected tracker");
  expect_one_line(participant_.run_besides("P2", {"--tracker", recorded}), 1,
                  "is recorded; name the connected tracker");
}

TEST_F(StudyRun, SaysWhatIsWrong) {
  participant_.write_protocol(one_trial_keys, short_look);
  EXPECT_THAT(participant_.run_besides("P2", {"--resume"}).errors,
              HasSubstr("no session to resume"));
  EXPECT_EQ(participant_.run_besides("Jane Doe", {}).exit_code, 2);
  expect_one_line(
      participant_.run_besides("P2", {"--gaze-filter", "hold"}), 2,
      "write the filter into the protocol's [tracker.filter], or rehearse with --pilot");
  expect_one_line(participant_.run_besides("P2", {"--pilot", "--gaze-filter", "hold=9"}), 2,
                  "give a number from 0.001 to 0.6");
}

}  // namespace
}  // namespace foveola::test
