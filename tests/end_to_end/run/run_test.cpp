// A person's whole session in the real window, by keys, and what its record then must hold.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/run/coverable_tracker.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/end_to_end/tracker_profile.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using namespace std::chrono_literals;

/// Everything that a session can have.
const char* const whole_keys = R"(
methods = ["od", "fv"]
phases = ["consent", "background", "validation", "reaction", "trials", "debrief"]
)";

std::string whole_tables() {
  return R"(
[texts]
consent = "You will look at pictures."

[tracker.validation]
points = 5
max_accuracy_deg = 45
max_precision_deg = 10
max_data_loss = 1.0
attempts = 2

[reaction]
presses = 2
shortest_wait_s = 0.3
longest_wait_s = 0.5

[[practice]]
scene = "hall"
method = "od"
)" + std::string(short_look) +
         questionnaire_table("background", {age_question, R"(
id = "games"
text = "How often do you play?"
)"}) + questionnaire_table("debrief", {R"(
id = "noticed"
text = "Did you notice anything?"
kind = "text"
required = false
)"});
}

/// Until the session has noticed both, that the tracker is lost and that it is back.
void cover_for_a_while(CoverableTracker& tracker, RunningProgram& program) {
  tracker.cover();
  program.wait_for("Note: the eye tracker sends no gaze");
  tracker.uncover();
  program.wait_for("Note: the eye tracker sends gaze again");
}

/// The film of each attempt of the whole session.
void expect_replay_bit_for_bit(const SeatedParticipant& participant) {
  const ProgramResult replayed = succeeded(participant.replay());
  const std::string the_same = ": [0-9]+ frames, [1-9][0-9]* samples: bit-identical\n";
  EXPECT_THAT(replayed.output,
              MatchesRegex("trial 0 \\(hall, od, practice\\), attempt 1" + the_same +
                           "trial 1 \\(hall, od\\), attempt 1" + the_same +
                           "trial 1 \\(hall, od\\), attempt 2" + the_same +
                           "trial 2 \\(hall, fv\\), attempt 1" + the_same +
                           "trial 2 \\(hall, fv\\), attempt 2" + the_same));
}

TEST_F(StudyRun, AWholeSessionByKeys) {
  participant_.write_protocol(whole_keys, whole_tables());
  CoverableTracker tracker;
  const std::string profile =
      participant_.folder().write("camera.toml", open_gaze_profile(tracker.port()));
  const fs::path receipt = participant_.folder() / "receipt.txt";
  participant_.begin({"--tracker", profile, "--receipt", receipt});
  participant_.answer_page("Return");  // welcome
  participant_.wait_for_page();        // consent
  participant_.type_all({"Return", "Down", "Return"});
  participant_.wait_for_page();  // background
  participant_.type_all({"3", "4", "Return", "2", "Return", "Return"});
  participant_.answer_page("Return");  // before the targets
  participant_.program().wait_for("The gaze was validated");
  participant_.answer_page("Return");  // before the reaction test
  for (int press = 0; press < 2; ++press) {
    participant_.wait_for_page();
    participant_.wait_for_signal();
    participant_.type("space");
    participant_.program().wait_for("A reaction came after");
  }
  participant_.answer_page("Return");  // practice
  participant_.wait_for_page();        // choosing: the wall is ahead, Tab goes on to the lamp
  participant_.type_all({"Tab", "Return"});
  time_trial();
  rate("3");

  participant_.answer_page("Return");  // from now on it counts
  participant_.wait_for_page();        // choosing: the lamp is ahead, Tab goes round to the wall
  participant_.type_all({"Tab", "Return"});
  time_trial();
  participant_.type("BackSpace");  // the timing went wrong
  participant_.wait_for_page();
  participant_.type_all({"Down", "Return"});
  const std::vector<KeyPress> first = time_trial();
  rate("4");

  participant_.answer_page("space");
  participant_.wait_for_page();
  cover_for_a_while(tracker, participant_.program());
  participant_.type("Escape");
  EXPECT_EQ(participant_.wait_for_page(), "paused");
  RunningProgram& program = participant_.program();
  program.type_line("note the phone rang");
  program.wait_for("Note: the phone rang");
  program.type_line("state");
  EXPECT_THAT(program.wait_for("paused"), HasSubstr("hall with fv"));
  program.type_line("quit");
  program.wait_for("--resume");
  EXPECT_EQ(program.wait_for_end(), 0);
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("interrupted"));

  EXPECT_THAT(read_file(receipt), AllOf(HasSubstr("You will look at pictures."),
                                        HasSubstr("Agreed to by participant P1 at 20")));
  participant_.begin({"--resume", "--tracker", profile});
  EXPECT_THAT(
      participant_.program().said(),
      HasSubstr("Next: ready to start, trial 3 of 3: hall with fv, timing 1, attempt 2; then "
                "questionnaire debrief"));
  const std::vector<KeyPress> second = time_trial();
  rate("5");
  participant_.wait_for_page();  // debrief
  participant_.type_all({"n", "o", "Return", "Return"});
  end_by_enter();
  EXPECT_THAT(
      participant_.program().said(),
      AllOf(HasSubstr("Session of P1: completed, "), ContainsRegex("1 +hall +od +Lamp .* practice"),
            ContainsRegex("2 +hall +od +Wall .* timing 2"), HasSubstr("Frames of the test trials"),
            HasSubstr("Validation 1: accuracy "), HasSubstr("Reactions: 2 from "),
            HasSubstr("the phone rang")));

  EXPECT_THAT(participant_.ask("SELECT type FROM event ORDER BY sequence"),
              ElementsAre("session_started", "consent_given", "questionnaire_answered",
                          "gaze_validated", "reaction_pressed", "reaction_pressed",
                          // practice
                          "object_chosen", "trial_started", "first_frame_presented", "marked",
                          "marked", "rated",
                          // od, timed twice
                          "object_chosen", "trial_started", "first_frame_presented", "marked",
                          "marked", "retime_requested", "trial_started", "first_frame_presented",
                          "marked", "marked", "rated",
                          // fv, without its tracker for a while, paused, interrupted, gone on with
                          "trial_started", "first_frame_presented", "note_written", "note_written",
                          "pause_requested", "note_written", "interrupted", "note_written",
                          "resumed", "trial_started", "first_frame_presented", "marked", "marked",
                          "rated", "questionnaire_answered"));
  EXPECT_THAT(participant_.ask("SELECT text FROM note ORDER BY sequence LIMIT 3"),
              ElementsAre("the eye tracker sends no gaze", "the eye tracker sends gaze again",
                          "the phone rang"));
  EXPECT_THAT(
      participant_.ask("SELECT questionnaire, question, number, text "
                       "FROM questionnaire_answer"),
      ElementsAre("background|age|34.0|-", "background|games|2.0|-", "debrief|noticed|-|no"));
  EXPECT_THAT(participant_.ask("SELECT trial, attempt, object, outcome FROM attempt "
                               "ORDER BY trial, attempt"),
              ElementsAre("0|1|Lamp|rated", "1|1|Wall|retimed", "1|2|Wall|rated", "2|1|Wall|paused",
                          "2|2|Wall|rated"));
  EXPECT_THAT(participant_.ask("SELECT trial, value FROM rating ORDER BY trial"),
              ElementsAre("0|3.0", "1|4.0", "2|5.0"));
  EXPECT_THAT(participant_.ask("SELECT state, kind FROM session"), ElementsAre("completed|human"));
  EXPECT_THAT(participant_.ask("SELECT count(*) FROM reaction WHERE early = 0"), ElementsAre("2"));

  // After their keys, and long before the next ones; AMarkHasTheTimeOfItsKey measures how long.
  const std::vector<double> marks_s = recorded_marks();
  ASSERT_EQ(marks_s.size(), 8U);
  const std::vector<double> last_s(marks_s.begin() + 4, marks_s.end());
  expect_marks_of({first[0], first[1], second[0], second[1]}, last_s);

  // A backup after each run, and a record without a fault.
  const fs::path backups = participant_.database().string() + ".backups";
  EXPECT_EQ(std::distance(fs::directory_iterator(backups), fs::directory_iterator()), 2);
  const study::Verification verified = study::verify_study(participant_.database());
  EXPECT_EQ(verified.events, 38U);
  EXPECT_TRUE(verified.faults.empty()) << verified.faults.front().what;
  EXPECT_TRUE(verified.gaps.empty()) << verified.gaps.front().what;

  expect_replay_bit_for_bit(participant_);
}

TEST_F(StudyRun, ATrialThatFollowsTheGazeWaitsForOne) {
  participant_.write_protocol("methods = [\"od\", \"fv\"]\nphases = [\"trials\"]\n", short_look);
  CoverableTracker tracker;
  participant_.begin(
      {"--tracker", participant_.folder().write("camera.toml", open_gaze_profile(tracker.port()))});
  RunningProgram& program = participant_.program();
  participant_.answer_page("Return");  // welcome
  tracker.cover();
  program.wait_for("Note: the eye tracker sends no gaze");
  participant_.answer_page("Return");  // choosing
  time_trial();                        // od needs no gaze
  rate("3");
  participant_.answer_page("space");
  program.wait_for("Note: the trial waits for a gaze");
  EXPECT_EQ(participant_.wait_for_page(), "armed") << "says so";
  std::this_thread::sleep_for(1s);
  tracker.uncover();
  for (int mark = 0; mark < 2; ++mark) {
    EXPECT_EQ(participant_.wait_for_page(), "marking");
    participant_.type("space");
  }
  participant_.wait_for_page();
  rate("4");
  end_by_enter();

  EXPECT_THAT(participant_.ask("SELECT trial, attempt, outcome FROM attempt ORDER BY trial"),
              ElementsAre("0|1|rated", "1|1|rated"));
  EXPECT_THAT(participant_.ask("SELECT (SELECT max(time_ns) FROM event WHERE type = "
                               "'first_frame_presented') - (SELECT max(time_ns) FROM event WHERE "
                               "type = 'trial_started') > 1000000000"),
              ElementsAre("1"))
      << "no time of the trial ran while it waited";
  participant_.expect_no_fault();
  EXPECT_EQ(participant_.replay().exit_code, 0);
}

TEST_F(StudyRun, AMachineThatSlowsDownIsToldOfWhileItDoes) {
  constexpr int halts = 5;
  constexpr std::chrono::milliseconds halt{150};
  constexpr std::chrono::milliseconds between{50};
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin();
  participant_.begin_trials();
  participant_.answer_page("space");  // ready
  EXPECT_EQ(participant_.wait_for_page(), "marking");
  for (int i = 0; i < halts; ++i) {
    participant_.program().kill(SIGSTOP);
    std::this_thread::sleep_for(halt);
    participant_.program().kill(SIGCONT);
    std::this_thread::sleep_for(between);
  }
  EXPECT_THAT(participant_.program().wait_for("missed their refresh"),
              HasSubstr("check for other programs"));
  participant_.quit();
}

}  // namespace
}  // namespace foveola::test
