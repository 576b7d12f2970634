// A day in a laboratory: participants sit down one after another before the real program, something
// goes wrong with most of them, and the analysis has to say with whom.
//
// It takes minutes, in real time, on a display without a screen, and wants a machine that does
// nothing else. Even so the processor draws there, beside the tracing, and whoever has a good day
// may have more late frames than a laboratory would accept. So of what a machine's speed alone
// decides, the test asks no more than that whoever had the slow machine, and nobody else, had the
// most.
#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/run/coverable_tracker.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/end_to_end/study/named_columns.h"
#include "tests/end_to_end/tracker_profile.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using namespace std::chrono_literals;

using Checks = std::set<std::string>;  ///< by their names in the report

const char* const late_frames = "Frames that missed their refresh";
const char* const without_gaze = "Frames without a valid gaze";
const char* const latency = "Latency, from the eye to the display";
const char* const mark_gap = "From a frame to the mark upon it, the longest";
const char* const out_of_view = "Marks with the object out of view";
const char* const elsewhere = "Trials with the gaze elsewhere";
const char* const cut_off = "Interrupted sessions";
const char* const timed_again = "Retimed trials";
const char* const noted = "Notes in the sessions’ records";

/// What they find hangs on the machine that the test runs on.
const Checks of_the_machine = {late_frames, latency, mark_gap};

const char* const slowed = "P5";  ///< whoever has the slow machine

class SimulatedDay;

/// A participant of the day.
struct Visit {
  std::string code;
  std::string what_went_wrong;
  Checks named_by;  ///< the checks that have to name them, but for those of_the_machine
  void (SimulatedDay::*take_part)(const std::string& code);
};

/// A program whose machine has other things to do, for as long as this lives: most of the time it
/// does not get a processor.
class SlowedDown {
 public:
  explicit SlowedDown(const RunningProgram& program)
      : thread_([&program](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            program.kill(SIGSTOP);
            std::this_thread::sleep_for(80ms);
            program.kill(SIGCONT);
            std::this_thread::sleep_for(40ms);
          }
        }) {}

 private:
  std::jthread thread_;
};

class SimulatedDay : public StudyRun {
 public:
  SimulatedDay() {
    participant_.set_refresh_rate(30);
    participant_.write_protocol("methods = [\"od\", \"vp\", \"fv\"]\nphases = [\"trials\"]\n",
                                std::string(short_look) + "[preflight]\n");
  }

  void good_day(const std::string& code) {
    sit_down(code);
    whole_trials(3);
    end_by_enter();
  }

  /// The tracker is covered for most of a trial that follows the gaze.
  void tracker_fails(const std::string& code) {
    sit_down(code);
    whole_trials(2);
    start_trial();
    tracker_.cover();
    participant_.program().wait_for("Note: the eye tracker sends no gaze");
    mark();
    mark();
    tracker_.uncover();
    participant_.program().wait_for("Note: the eye tracker sends gaze again");
    rate("3");
    end_by_enter();
  }

  /// The mouse rests outside the window when a trial is to follow it, and then in a corner.
  void mouse_rests(const std::string& code) {
    participant_.seat(code);
    participant_.begin();
    participant_.begin_trials();
    whole_trials(2);
    participant_.wait_for_page();
    participant_.point_at(900, 700);
    look();  // longer than the pointer counts as seen
    participant_.type("space");
    participant_.program().wait_for("Note: the trial waits for a gaze");
    EXPECT_EQ(participant_.wait_for_page(), "armed");
    participant_.point_at(4, 4);
    EXPECT_EQ(participant_.wait_for_page(), "marking");
    mark();
    mark();
    rate("3");
    end_by_enter();
  }

  /// The view is 16 degrees wide, and a keystroke turns it by more than two.
  void turns_away(const std::string& code) {
    sit_down(code);
    start_trial();
    mark();
    look();
    participant_.type_all(std::vector<std::string>(8, "Right"));
    participant_.type("space");
    participant_.program().wait_for("material was marked while the object");
    participant_.wait_for_page();
    rate("3");
    whole_trials(2);
    end_by_enter();
  }

  void machine_slows_down(const std::string& code) {
    sit_down(code);
    {
      const SlowedDown machine(participant_.program());
      whole_trials(3);
    }
    end_by_enter();
  }

  void program_is_killed(const std::string& code) {
    sit_down(code);
    whole_trial();
    start_trial();
    mark();
    participant_.program().kill(SIGKILL);
    EXPECT_EQ(participant_.program().wait_for_end(), 128 + SIGKILL);
    participant_.begin({"--resume", "--tracker", camera_});
    whole_trials(2);
    end_by_enter();
  }

  void times_a_trial_again(const std::string& code) {
    sit_down(code);
    whole_trial();
    start_trial();
    mark();
    mark();
    participant_.type("BackSpace");
    participant_.wait_for_page();
    participant_.type_all({"Down", "Return"});
    whole_trials(2);
    end_by_enter();
  }

 protected:
  /// Begins a session before a tracked eye, until the first trial is to be started.
  void sit_down(const std::string& code) {
    participant_.seat(code);
    participant_.begin({"--tracker", camera_});
    participant_.begin_trials();
  }

  void start_trial() {
    participant_.answer_page("space");
    EXPECT_EQ(participant_.wait_for_page(), "marking");
  }

  void mark() {
    look();
    participant_.type("space");
    participant_.wait_for_page();
  }

  /// For a time that differs from mark to mark, as people's do.
  void look() {
    std::this_thread::sleep_for(
        std::chrono::milliseconds(std::uniform_int_distribution(1000, 2500)(random_)));
  }

  /// From the question whether the participant is ready to the rating.
  void whole_trial() {
    start_trial();
    mark();
    mark();
    rate("3");
  }

  void whole_trials(int count) {
    for (int trial = 0; trial < count; ++trial) {
      whole_trial();
    }
  }

  /// `foveola analyze` of the day.
  void analyse() const {
    succeeded(run_foveola({"analyze", participant_.database().string(), "-o", out_.string()}));
  }

  std::mt19937 random_{2018};
  CoverableTracker tracker_;
  const std::string camera_ =
      participant_.folder().write("camera.toml", open_gaze_profile(tracker_.port()));
  const fs::path out_ = participant_.folder() / "out";
};

/// The part of what a check found in which it names those who miss its limit.
std::string names_in(const std::string& found) {
  const std::string before_names = "above the limit: ";
  const std::size_t begin = found.find(before_names);
  return begin == std::string::npos ? found : found.substr(begin + before_names.size());
}

/// The flagged checks that name each participant, from an analysis's output.
std::map<std::string, Checks> namings(const fs::path& analysis, const std::vector<Visit>& visits) {
  const std::string report = read_file(analysis / "report.html");
  std::map<std::string, Checks> named;
  for (const NamedFields& check : rows_of_csv(analysis / "data_quality.csv")) {
    const std::string& name = check.at("check");
    if (check.at("verdict") != "flagged") {
      continue;
    }
    fmt::print("{}: {}\n", name, check.at("found"));
    EXPECT_THAT(report, HasSubstr("⚑ " + name));
    for (const Visit& visit : visits) {
      if (names_in(check.at("found")).find(visit.code) != std::string::npos) {
        named[visit.code].insert(name);
      }
    }
  }
  return named;
}

/// Of each participant's frames those that were late, in per cent.
std::map<std::string, double> late_percents(const fs::path& analysis) {
  std::map<std::string, double> percents;
  for (const NamedFields& row : rows_of_csv(analysis / "latency.csv")) {
    percents[row.at("participant")] =
        100.0 * std::stod(row.at("late_frames")) / std::stod(row.at("frames"));
  }
  return percents;
}

Checks without(Checks checks, const Checks& others) {
  std::erase_if(checks, [&](const std::string& check) { return others.contains(check); });
  return checks;
}

void print_day(const std::vector<Visit>& visits, const std::map<std::string, Checks>& named,
               const std::map<std::string, double>& late) {
  fmt::print("\n{:<4} {:<45} {:>7}  {}\n", "", "what went wrong", "late, %", "named by");
  for (const Visit& visit : visits) {
    const auto by = named.find(visit.code);
    fmt::print("{:<4} {:<45} {:>7.1f}  {}\n", visit.code, visit.what_went_wrong,
               late.at(visit.code),
               by == named.end() ? "-" : fmt::format("{}", fmt::join(by->second, "; ")));
  }
}

TEST_F(SimulatedDay, WhateverGoesWrongIsNamedAndNobodyElse) {
  const std::vector<Visit> visits = {
      {"P1", "nothing", {}, &SimulatedDay::good_day},
      {"P2",
       "the tracker was covered for most of a trial",
       {noted, without_gaze},
       &SimulatedDay::tracker_fails},
      {"P3",
       "the mouse was the eye, and rested elsewhere",
       {noted, elsewhere},
       &SimulatedDay::mouse_rests},
      {"P4",
       "turned away from the object before a mark",
       {noted, out_of_view},
       &SimulatedDay::turns_away},
      {slowed, "the machine slowed down", {}, &SimulatedDay::machine_slows_down},
      {"P6", "the program was killed in a trial", {cut_off}, &SimulatedDay::program_is_killed},
      {"P7",
       "asked for a trial to be timed again",
       {timed_again},
       &SimulatedDay::times_a_trial_again},
      {"P8", "nothing", {}, &SimulatedDay::good_day}};
  for (const Visit& visit : visits) {
    (this->*visit.take_part)(visit.code);
  }
  EXPECT_THAT(participant_.ask("SELECT DISTINCT kind, state FROM session"),
              ElementsAre("human|completed"));
  participant_.expect_no_fault();

  analyse();
  std::map<std::string, Checks> named = namings(out_, visits);
  const std::map<std::string, double> late = late_percents(out_);
  print_day(visits, named, late);
  EXPECT_TRUE(named[slowed].contains(late_frames));
  for (const Visit& visit : visits) {
    EXPECT_EQ(without(named[visit.code], of_the_machine), visit.named_by) << visit.code;
    EXPECT_LE(late.at(visit.code), late.at(slowed)) << visit.code;
  }
}

}  // namespace
}  // namespace foveola::test
