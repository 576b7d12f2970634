// Studies' files that were written once and stay as they are (tests/data/schema-4, schema-5):
// whatever becomes of the program, it reads them as they were, and continues one of schema 5. What
// is expected was read from their tables by sqlite3.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "tests/end_to_end/hall.h"
#include "tests/end_to_end/run/seated_participant.h"
#include "tests/end_to_end/study/named_columns.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

std::string kept_file(const std::string& name, const std::string& schema = "schema-4") {
  return read_file(fs::path(TEST_DATA_DIR) / schema / name);
}

/// Copies the study, and all that its protocol names to where the program looks for it.
void copy_kept_study(const TemporaryFolder& folder, const std::string& schema,
                     const std::string& scene) {
  const std::vector<std::pair<std::string, std::string>> places = {
      {"study.sqlite", "study.sqlite"},
      {"keys.toml", "share/protocols/keys.toml"},
      {"hall.toml", "share/scenes/hall.toml"},
      {scene, "real/" + scene},
      {"desktop.toml", "share/data/displays/desktop.toml"},
      {"pointer.toml", "share/data/trackers/pointer.toml"}};
  for (const auto& [name, place] : places) {
    folder.write(place, kept_file(name, schema));
  }
}

class KeptStudy : public testing::Test {
 protected:
  KeptStudy() { copy_kept_study(hall_.folder, "schema-4", "hall.gltf"); }

  ProgramResult run(const std::vector<std::string>& arguments) const {
    return hall_.run(arguments);
  }

  /// What a command says with --json, which must succeed.
  nlohmann::json json_of(std::vector<std::string> arguments) const {
    arguments.emplace_back("--json");
    const ProgramResult result = succeeded(run(arguments));
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
  EXPECT_THAT(found.at("gaps").at(0).at("what"),
              HasSubstr("whether frames, gaze or films were exchanged"));
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
  const ProgramResult analysed =
      succeeded(run_foveola({"analyze", study_, "-o", path_of("report")}));
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
  EXPECT_THAT(frames, Contains("PROGRAM-1 81"));
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

TEST_F(KeptStudy, IsMergedWithItsOwnKindAlone) {
  const std::string part = hall_.folder.write("part/part.sqlite", kept_file("study.sqlite"));
  for (const char* participant : {"PROGRAM-1", "PROGRAM-2"}) {
    succeeded(run({"study", "forget", part, participant, "--yes"}));
  }
  const std::string all = path_of("all.sqlite");
  EXPECT_THAT(run({"study", "merge", part, study_, "-o", all}).output,
              HasSubstr(": 6 sessions, 4 of them in several files: "));
  EXPECT_THAT(json_of({"study", "verify", all}).at("faults"), IsEmpty());
  const std::string newer = path_of("newer.sqlite");
  succeeded(run({"study", "simulate", "keys", "--db", newer, "--participants", "1"}));
  expect_one_line(run({"study", "merge", study_, newer, "-o", path_of("both.sqlite")}), 1,
                  "newer.sqlite: has schema 5, and " + study_ + " has 4");
}

TEST_F(KeptStudy, GetsNoMoreSessions) {
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"study", "simulate", "keys", "--db", study_, "--participants", "1"},
           {"study", "run", "keys", "--db", study_, "--participant", "PROGRAM-2", "--window",
            "640x480", "--resume"}}) {
    const ProgramResult refused = run(command);
    expect_one_line(refused, 1, "has schema 4, in which this program records no sessions");
    EXPECT_THAT(refused.errors,
                AllOf(HasSubstr("Foveola 0.1.0"), HasSubstr("docs/howto/older-studies.md")));
  }
  EXPECT_EQ(read_file(study_), kept_file("study.sqlite"));
}

TEST(KeptNewStudy, IsReadAndContinuedAsItWas) {
  SeatedParticipant participant;
  copy_kept_study(participant.folder(), "schema-5", "hall.glb");
  const std::string study = participant.database();
  const fs::path head = fs::path(TEST_DATA_DIR) / "schema-5/head.txt";
  const ProgramResult verified =
      succeeded(run_foveola({"study", "verify", study, "--head", head.string()}));
  EXPECT_THAT(verified.output,
              AllOf(HasSubstr("sessions  2\nevents    19\nchunks    4\nfaults    0\n"),
                    HasSubstr("PROGRAM-2: trial 0, attempt 1 is open: no event states its frames,"
                              " gaze and films\n")));
  // The printout is from before what was forgotten was listed, too.
  EXPECT_THAT(participant.status().output, StartsWith(read_file(head)));
  EXPECT_EQ(read_file(study), kept_file("study.sqlite", "schema-5")) << "reading changes nothing";

  expect_one_line(participant.run_besides("PROGRAM-9", {}), 1, "has sessions by Foveola 0.2.0");
  participant.seat("PROGRAM-2");
  participant.begin({"--resume", "--despite-changes"});
  for (int trial = 0; trial < 2; ++trial) {
    EXPECT_EQ(participant.wait_for_page(), "ready");
    participant.type("space");
    for (int mark = 0; mark < 2; ++mark) {
      EXPECT_EQ(participant.wait_for_page(), "marking");
      participant.type("space");
    }
    participant.answer_page("Return");  // to look around
    participant.wait_for_page();        // the rating
    participant.type_all({"4", "Return", "Return"});
  }
  participant.answer_page("Return");
  EXPECT_EQ(participant.program().wait_for_end(), 0);
  succeeded(run_foveola({"study", "verify", study, "--head", head.string()}));
  EXPECT_THAT(participant.ask("SELECT trial, attempt, outcome FROM attempt WHERE session = 3"),
              ElementsAre("0|1|interrupted", "0|2|rated", "1|1|rated"));
  EXPECT_THAT(participant.ask("SELECT CAST(time_ns AS TEXT) FROM mark WHERE session = 1"
                              " ORDER BY trial, attempt, time_ns"),
              ElementsAre("301472674", "931237820", "386816622", "1117546927"));
}

}  // namespace
}  // namespace foveola::test
