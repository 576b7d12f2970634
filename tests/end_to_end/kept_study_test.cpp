// A study's file of schema 4 that was written once and stays as it is (tests/data/schema-4):
// whatever becomes of the program, it reads the file as it was, and goes on with it. What is
// expected was read from the file's tables by sqlite3.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include "renderer/base/files.h"
#include "tests/end_to_end/hall.h"
#include "tests/end_to_end/named_columns.h"
#include "tests/end_to_end/seated_participant.h"
#include "tests/end_to_end/study_rows.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string kept_file(const std::string& name) {
  return read_file(fs::path(TEST_DATA_DIR) / "schema-4" / name);
}

/// Copies the study, and all that its protocol names to where the program looks for it.
void copy_kept_study(const TemporaryFolder& folder) {
  const std::vector<std::pair<std::string, std::string>> places = {
      {"study.sqlite", "study.sqlite"},
      {"keys.toml", "share/protocols/keys.toml"},
      {"hall.toml", "share/scenes/hall.toml"},
      {"hall.gltf", "real/hall.gltf"},
      {"desktop.toml", "share/data/displays/desktop.toml"},
      {"pointer.toml", "share/data/trackers/pointer.toml"}};
  for (const auto& [name, place] : places) {
    folder.write(place, kept_file(name));
  }
}

class KeptStudy : public testing::Test {
 protected:
  KeptStudy() { copy_kept_study(hall_.folder); }

  ProgramResult run(const std::vector<std::string>& arguments) const {
    return hall_.run(arguments);
  }

  /// What a command says with --json, which must succeed.
  nlohmann::json json_of(std::vector<std::string> arguments) const {
    arguments.emplace_back("--json");
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output);
  }

  std::string path_of(const std::string& name) const { return (hall_.folder / name).string(); }

  Hall hall_;
  const std::string study_ = path_of("study.sqlite");
};

TEST_F(KeptStudy, IsWhole) {
  const nlohmann::json found = json_of({"study", "verify", study_});
  EXPECT_EQ(found.at("sessions"), 6);
  EXPECT_EQ(found.at("events"), 157);
  EXPECT_EQ(found.at("chunks"), 38);
  EXPECT_THAT(found.at("faults"), IsEmpty());
  EXPECT_THAT(found.at("warnings"), IsEmpty()) << "one program wrote it";
  EXPECT_EQ(read_file(study_), kept_file("study.sqlite")) << "reading changes nothing";
}

TEST_F(KeptStudy, SaysWhoTookPart) {
  const nlohmann::json status = json_of({"study", "status", study_});
  EXPECT_EQ(
      status.at("kinds").at("human").at("sessions"),
      nlohmann::json::parse(R"({"completed": 2, "excluded": 1, "marking": 1, "withdrawn": 1})"));
  EXPECT_EQ(status.at("kinds").at("pilot").at("sessions"),
            nlohmann::json::parse(R"({"completed": 1})"));
  EXPECT_EQ(status.at("trials_done"), 7);
  ASSERT_EQ(status.at("programs").size(), 1U);
  EXPECT_EQ(status.at("programs").at(0).at("program"),
            "Foveola 0.1.0 (GNU 12.2.0, Release, Embree 3.13.5)");
  ASSERT_EQ(status.at("amended").size(), 1U);
  EXPECT_EQ(status.at("amended").at(0).at("participant"), "PROGRAM-6");
  EXPECT_EQ(status.at("amended").at(0).at("changed"),
            nlohmann::json::parse(R"(["timing.mark_timeout_s"])"));
}

TEST_F(KeptStudy, PrintsASessionOnAPage) {
  EXPECT_THAT(run({"study", "summary", study_, "--participant", "PROGRAM-1"}).output,
              AllOf(HasSubstr("Session of PROGRAM-1: completed"),
                    HasSubstr("Foveola 0.1.0 (GNU 12.2.0, Release, Embree 3.13.5)"),
                    HasSubstr("a test program presses the keys; no person takes part"),
                    HasSubstr("the phone rang")));
}

TEST_F(KeptStudy, GivesItsGazeOut) {
  const std::string gaze = path_of("gaze.csv");
  const ProgramResult result =
      run({"study", "gaze", study_, "--participant", "PROGRAM-1", "--trial", "1", "-o", gaze});
  EXPECT_EQ(result.output, gaze + ": 265 samples\n") << result.errors;
}

TEST_F(KeptStudy, IsAnalysedAsItWas) {
  const ProgramResult analysed = run_foveola({"analyze", study_, "-o", path_of("report")});
  ASSERT_EQ(analysed.exit_code, 0) << analysed.errors;
  std::vector<std::string> trials;
  for (NamedFields& row : rows_of_csv(hall_.folder / "report/trials_long.csv")) {
    if (row["status"] == "analysed" && row["trial_kind"] == "test") {
      trials.push_back(fmt::format("{} {} {} {:.6f} {} {:.6f} {} {}", row["participant"],
                                   row["method"], row["attempt"], std::stod(row["outline_s"]),
                                   row["outline_censored"], std::stod(row["material_s"]),
                                   row["material_censored"], row["artifacts_rating"]));
    }
  }
  EXPECT_THAT(trials, ElementsAre("PROGRAM-1 od 2 0.492778 FALSE 1.122334 FALSE 3",
                                  "PROGRAM-1 fv 2 0.379920 FALSE 0.925389 FALSE 2",
                                  "PROGRAM-6 od 1 0.409282 FALSE 0.917078 FALSE 3",
                                  "PROGRAM-6 fv 1 0.413664 FALSE 2.000000 TRUE 4"));
  std::vector<std::string> frames;
  for (NamedFields& row : rows_of_csv(hall_.folder / "report/latency.csv")) {
    frames.push_back(row["participant"] + " " + row["frames"]);
  }
  EXPECT_THAT(frames, testing::Contains("PROGRAM-1 81"));
}

// Which films come out depends on the program and the processor; what happened does not.
TEST_F(KeptStudy, IsReplayed) {
  const nlohmann::json replayed =
      json_of({"study", "replay", study_, "--participant", "PROGRAM-1"});
  EXPECT_FALSE(replayed.contains("difference")) << replayed.dump();
  std::vector<std::string> attempts;
  for (const nlohmann::json& attempt : replayed.at("attempts")) {
    attempts.push_back(fmt::format("{} {}: {}", attempt.at("trial").get<int>(),
                                   attempt.at("attempt").get<int>(),
                                   attempt.at("frames").get<int>()));
    EXPECT_TRUE(attempt.at("first_difference").is_null() || replayed.at("approximate") != "");
  }
  EXPECT_THAT(attempts,
              ElementsAre("0 1: 38", "1 1: 36", "1 2: 42", "2 1: 64", "3 1: 8", "3 2: 39"));
}

TEST_F(KeptStudy, TakesInAnotherParticipantAndAnotherFile) {
  const std::string other = path_of("other.sqlite");
  const auto simulate = [&](const std::string& file) {
    return run({"study", "simulate", "keys", "--db", file, "--participants", "1"});
  };
  ASSERT_EQ(simulate(other).exit_code, 0);
  const std::string all = path_of("all.sqlite");
  EXPECT_EQ(run({"study", "merge", study_, other, "-o", all}).output,
            all + ": 7 sessions, 0 of them in several files\n");
  const ProgramResult added = simulate(study_);
  EXPECT_EQ(added.exit_code, 0) << added.errors;
  for (const std::string& file : {all, study_}) {
    const nlohmann::json found = json_of({"study", "verify", file});
    EXPECT_EQ(found.at("sessions"), 7);
    EXPECT_THAT(found.at("faults"), IsEmpty());
  }
}

/// As if a program of this version had begun the sessions, but for the hashes of their logs.
void begun_by_version(const fs::path& study, const std::string& version) {
  const std::string guard =
      value_of(study, "SELECT sql FROM sqlite_schema WHERE name = 'session_changes_state_only'");
  const std::string over =
      value_of(study, "SELECT sql FROM sqlite_schema WHERE name = 'session_ends_once'");
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(study.c_str(), &database), SQLITE_OK);
  const std::string sql =
      "DROP TRIGGER session_changes_state_only; DROP TRIGGER session_ends_once;"
      " UPDATE session SET program_version = '" +
      version + "'; " + guard + "; " + over;
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
}

TEST(KeptSession, GoesOnByAnotherProgramWhereThatIsSaidAndNamesBoth) {
  SeatedParticipant participant;
  copy_kept_study(participant.folder());
  begun_by_version(participant.database(), "0.0.9");
  expect_one_line(participant.run_besides("PROGRAM-2", {"--resume"}), 1,
                  "participant PROGRAM-2: has a session by Foveola 0.0.9 (");

  participant.seat("PROGRAM-2");
  participant.begin({"--resume", "--despite-changes"});
  EXPECT_EQ(participant.wait_for_page(), "ready");
  participant.type("space");
  for (int mark = 0; mark < 2; ++mark) {
    EXPECT_EQ(participant.wait_for_page(), "marking");
    participant.type("space");
  }
  participant.answer_page("Return");  // to look around
  participant.wait_for_page();        // the rating
  participant.type_all({"4", "Return", "Return"});
  participant.wait_for_page();
  participant.program().type_line("quit");
  EXPECT_EQ(participant.program().wait_for_end(), 0);

  EXPECT_THAT(
      participant.ask("SELECT text FROM note JOIN session ON session.id = session WHERE participant"
                      " = 'PROGRAM-2' AND text LIKE '% instead of %'"),
      ElementsAre(
          AllOf(StartsWith("goes on with Foveola "), HasSubstr(" instead of Foveola 0.0.9 ("))));
  EXPECT_THAT(participant.ask(
                  "SELECT trial, attempt, outcome FROM attempt JOIN session ON session.id ="
                  " session WHERE participant = 'PROGRAM-2' ORDER BY attempt.rowid DESC LIMIT 2"),
              ElementsAre("2|2|rated", "2|1|interrupted"));
  EXPECT_THAT(participant.status().output, HasSubstr("PROGRAM-2 by Foveola 0.0.9 ("));
  expect_one_line(participant.run_besides("PROGRAM-4", {"--resume"}), 1, "which is excluded");
}

}  // namespace
}  // namespace foveola::test
