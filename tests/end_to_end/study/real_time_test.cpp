// Simulated participants before the real window, in real time.
#include <csignal>

#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/hall.h"
#include "tests/end_to_end/running_program.h"
#include "tests/end_to_end/study_rows.h"
#include "tests/matchers.h"
#include "tests/waiting.h"
#include "tests/x_server.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

/// Marks are waited for longer than any machine takes.
const char* const small_tables_of_a_room = R"(
[film]
width = 96
height = 48
max_depth = 2

[display]
view_width = 64
view_height = 64
fov_deg = 90

[reference]
samples_per_pixel = 8
samples_per_object = 50000

[timing]
mark_timeout_s = 600
rating_s = 0.5
)";

const char* const whole_procedure = R"(
[texts]
consent = "You will look at pictures."

[tracker.validation]
points = 5
max_accuracy_deg = 2
max_precision_deg = 2
max_data_loss = 0.5

[reaction]
presses = 2
shortest_wait_s = 0.3
longest_wait_s = 0.5

[[questionnaire]]
id = "background"
title = "About you"
intro = "A few questions."
[[questionnaire.question]]
id = "age"
text = "How old are you?"
kind = "number"
minimum = 18
maximum = 99
[[questionnaire.question]]
id = "games"
text = "How often do you play?"
[[questionnaire.question]]
id = "hand"
text = "Which hand?"
kind = "choice"
[[questionnaire.question.options]]
label = "the left one"
[[questionnaire.question.options]]
label = "the right one"
[[questionnaire.question]]
id = "noticed"
text = "Did you notice anything?"
kind = "text"
)";

class RealTime : public ::testing::Test {
 protected:
  void write_protocol(const std::string& keys, const std::string& tables) const {
    hall_.folder.write("room.toml", "name = \"room\"\ntitle = \"A room\"\nscenes = [\"arcade\"]\n" +
                                        keys + small_tables_of_a_room + tables);
  }

  fs::path database() const { return hall_.folder / "study.sqlite"; }

  std::vector<std::string> command(const std::vector<std::string>& options) const {
    return joined({"study", "simulate", (hall_.folder / "room.toml").string(), "--db",
                   database().string(), "--participants", "1", "--seed", "3", "--real-time"},
                  options);
  }

  /// The program's own scenes, in this test's cache.
  Environment environment() const {
    return {{"XDG_CACHE_HOME", (hall_.folder / "cache").string()}};
  }

  void simulate(const std::vector<std::string>& options = {}) const {
    const ProgramResult result = succeeded(run_foveola(command(options), environment()));
    EXPECT_THAT(result.output, HasSubstr("of real time"));
  }

  Rows ask(const std::string& sql) const { return all_rows_of(database(), sql); }
  Rows events() const { return ask("SELECT type FROM event ORDER BY sequence"); }

  study::Verification verify() const {
    study::Verification verified = study::verify_study(database());
    EXPECT_TRUE(verified.faults.empty()) << verified.faults.front().what;
    return verified;
  }

  XServer server_;
  Hall hall_;
};

TEST_F(RealTime, AWholeSessionBeforeTheWindow) {
  write_protocol(
      "methods = [\"fv\"]\n"
      "phases = [\"consent\", \"background\", \"validation\", \"reaction\", \"trials\"]\n",
      std::string(whole_procedure) + "[tracker.filter]\nhold_s = 0.3\n");
  simulate();
  EXPECT_THAT(ask("SELECT kind, state, json_extract(devices, '$.simulation.real_time'), "
                  "json_extract(devices, '$.display.framebuffer'), "
                  "json_extract(devices, '$.tracker.filter.hold_s') FROM session"),
              ElementsAre("simulated|completed|1|[64,64]|0.3"));
  EXPECT_THAT(events(),
              ElementsAre("session_started", "consent_given", "questionnaire_answered",
                          "gaze_validated", "reaction_pressed", "reaction_pressed", "object_chosen",
                          "trial_started", "first_frame_presented", "marked", "marked", "rated"));
  EXPECT_THAT(ask("SELECT question FROM questionnaire_answer"),
              ElementsAre("age", "games", "hand", "noticed"));
  EXPECT_THAT(ask("SELECT early FROM reaction"), ElementsAre("0", "0"));
  EXPECT_THAT(ask("SELECT censored FROM mark"), Each("0"));
  EXPECT_TRUE(verify().gaps.empty());
  const ProgramResult replayed = succeeded(run_foveola(
      {"study", "replay", database().string(), "--participant", "P001"}, environment()));
  EXPECT_THAT(replayed.output, HasSubstr("bit-identical"));
}

TEST_F(RealTime, WhatWasKilledGoesOn) {
  write_protocol("methods = [\"fv\"]\nphases = [\"trials\"]\n", "");
  {
    RunningProgram program(command({}), environment());
    wait_until("a first frame", [&] {
      const auto rows =
          rows_of(database(), "SELECT 1 FROM event WHERE type = 'first_frame_presented'");
      return program.has_ended() || (rows && !rows->empty());
    });
    program.kill(SIGKILL);
    EXPECT_EQ(program.wait_for_end(), 128 + SIGKILL) << program.said();
  }
  simulate({"--resume"});
  EXPECT_THAT(ask("SELECT state FROM session"), ElementsAre("completed"));
  EXPECT_EQ(ask("SELECT outcome FROM attempt ORDER BY trial, attempt").back(), "rated");
  EXPECT_THAT(ask("SELECT count(*) > 1 FROM attempt"), ElementsAre("1"));
  verify();
}

TEST_F(RealTime, WhatExcludesItIsRefused) {
  write_protocol("methods = [\"fv\"]\nphases = [\"trials\"]\n", "");
  expect_one_line(run_foveola(command({"--predicted"}), environment()), 2, "--predicted");
  expect_one_line(run_foveola(command({"--jobs", "2"}), environment()), 2, "--jobs");
  EXPECT_FALSE(fs::exists(database()));
}

}  // namespace
}  // namespace foveola::test
