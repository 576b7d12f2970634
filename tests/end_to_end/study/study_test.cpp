// From a protocol to a report, with the built program, and the results read back.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "study/record/read/study_records.h"
#include "tests/end_to_end/study/study_of_a_hall.h"
#include "tests/end_to_end/study_rows.h"
#include "tests/end_to_end/tracker_profile.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

/// One scene, two participants, a film of 96 x 48: seconds of work.
const char* const small_protocol = R"(
name = "small"
title = "A small study for the tests"
scenes = ["meeting-room"]
methods = ["od", "vp", "fv"]

[machine]
samples_per_second = 3845  # the demo's, scaled with the film's area

[film]
width = 96
height = 48
max_depth = 3

[display]
view_width = 40
view_height = 40

[reference]
samples_per_pixel = 32
samples_per_object = 20000
)";

TEST(Study, GoesFromAProtocolToAReport) {
  const TemporaryFolder folder;
  write_file(folder / "small.toml", small_protocol);
  const fs::path database = folder / "study.sqlite";
  const ProgramResult simulated =
      succeeded(run_foveola({"study", "simulate", (folder / "small.toml").string(), "--db",
                             database.string(), "--participants", "2", "--seed", "5", "--json"}));

  EXPECT_EQ(value_of(database, "PRAGMA journal_mode"), "delete");
  EXPECT_EQ(value_of(database, "PRAGMA integrity_check"), "ok");
  const study::StudyRecords records = study::read_study(database);
  ASSERT_EQ(records.sessions.size(), 2U);
  EXPECT_EQ(records.sessions[0].kind, "simulated");
  EXPECT_EQ(records.sessions[0].state, "completed");
  ASSERT_EQ(records.trials.size(), 6U);
  ASSERT_EQ(records.measures.size(), 3U);
  for (std::size_t row = 0; row < records.trials.size(); ++row) {
    const study::Value& outline = records.value(row, 0);
    const study::Value& material = records.value(row, 1);
    const study::Value& artifacts = records.value(row, 2);
    EXPECT_NE(outline.state, study::Value::State::missing);
    EXPECT_NE(material.state, study::Value::State::missing);
    ASSERT_TRUE(artifacts.is_measured());
    EXPECT_GT(outline.number, 0.0);
    EXPECT_GE(material.number, outline.number);
    EXPECT_GE(artifacts.number, 1.0);
    EXPECT_LE(artifacts.number, 5.0);
  }

  succeeded(run_foveola({"analyze", database.string(), "-o", (folder / "out").string()}));
  const std::string report = read_file(folder / "out" / "report.html");
  EXPECT_THAT(report, HasSubstr("imulated"));
  EXPECT_THAT(report, HasSubstr("<svg"));
  EXPECT_THAT(report, HasSubstr(records.protocol.sha256));
}

TEST(Study, IsPreparedWithoutADatabase) {
  using Options = std::vector<std::string>;
  const TemporaryFolder folder;
  write_file(folder / "small.toml", small_protocol);
  const auto prepare = [&](const Options& options) {
    return run_foveola(joined(
        {"study", "simulate", (folder / "small.toml").string(), "--participants", "2"}, options));
  };
  const ProgramResult prepared =
      succeeded(prepare({"--prepare", "--json", "--shard", "1/1", "--seed", "9"}));
  EXPECT_EQ(nlohmann::json::parse(prepared.output).at("items"), 1);
  const std::string database = (folder / "a.sqlite").string();
  for (const Options& options :
       {Options{}, Options{"--prepare", "--db", database}, Options{"--prepare", "--resume"},
        Options{"--prepare", "--report", folder.path().string()}}) {
    expect_one_line(prepare(options), 2, "--");
  }
  EXPECT_THAT(folder.entries(), ElementsAre("small.toml"));
}

std::string recorded_digest(const fs::path& database) {
  return value_of(database, "SELECT file_sha256 FROM session_scene");
}

TEST_F(StudyOfAHall, AnotherFileIsWarnedOfAndNotMixedIn) {
  const ProgramResult first = succeeded(simulate("study.sqlite"));
  EXPECT_THAT(first.errors, Not(HasSubstr("warning")));
  EXPECT_EQ(recorded_digest(folder / "study.sqlite"), digest);
  std::string other = room_glb();
  other.replace(other.find("room"), 4, "hall");
  folder.write("real/hall.glb", other);
  const ProgramResult mixed = simulate("study.sqlite");
  EXPECT_EQ(mixed.exit_code, 1);
  EXPECT_THAT(mixed.errors, HasSubstr("its sessions saw another file as hall"));
  EXPECT_EQ(value_of(folder / "study.sqlite", "SELECT count(*) FROM session"), "1");
  const ProgramResult alone = succeeded(simulate("other.sqlite"));
  EXPECT_THAT(alone.errors, HasSubstr("hall.glb is not the file that the descriptor"));
  EXPECT_NE(recorded_digest(folder / "other.sqlite"), digest);
}

TEST_F(StudyOfAHall, SensitivityIsMeasuredByChangingPeople) {
  const fs::path out = folder / "bench";
  fs::create_directory(out);
  const auto bench = [&](const std::string& number) {
    return run({"bench", "sensitivity", "hall", "--participants", "2", "--seed", "1", "--factor",
                "3", "-o", out.string(), "--json", "--number", number});
  };
  EXPECT_THAT(bench("decision.lapse_s").errors, HasSubstr("has a single method"));
  std::string protocol = hall_protocol();
  protocol.replace(protocol.find(R"(["od"])"), 6, R"(["od", "vp"])");
  folder.write("share/protocols/hall.toml", protocol);
  const ProgramResult unknown = bench("decision.courage");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.errors, HasSubstr("decision.courage: is not a number in a population file"));
  EXPECT_THAT(bench("decision.impatience_per_s").errors,
              HasSubstr("is 0, which no factor changes"));
  EXPECT_TRUE(fs::is_empty(out));

  const ProgramResult first = succeeded(bench("decision.lapse_s"));
  const nlohmann::json outcomes = nlohmann::json::parse(first.output).at("outcomes");
  ASSERT_EQ(outcomes.size(), 3U) << "as they are, a third, three times";
  EXPECT_EQ(outcomes[2].at("value"), 3.0);
  EXPECT_EQ(outcomes[2].at("means").size(), 2U) << "VP, until the outline and the material";
  std::set<std::string> people;
  for (const char* study : {"adults", "decision.lapse_s-0.333333", "decision.lapse_s-3"}) {
    people.insert(value_of(out / fmt::format("{}.sqlite", study),
                           "SELECT devices ->> '$.simulation.people_sha256' FROM session"));
  }
  EXPECT_EQ(people.size(), 3U);
  EXPECT_EQ(bench("decision.lapse_s").output, first.output) << "gone on with";
}

// At 120 Hz, of which the attempt's frames say how long it was.
TEST_F(StudyOfAHall, EveryGazeSampleIsKeptAndCanBeReplayed) {
  succeeded(simulate("study.sqlite"));
  const auto value = [&](const std::string& sql) { return value_of(folder / "study.sqlite", sql); };
  const double frames = std::stod(value("SELECT sum(frame_count) FROM frame_chunk"));
  const double samples = std::stod(value("SELECT sum(sample_count) FROM gaze_chunk"));
  EXPECT_NEAR(samples, frames / 70.0 * 120.0, 2.0);
  const ProgramResult gaze =
      succeeded(run_foveola({"study", "gaze", (folder / "study.sqlite").string(), "--participant",
                             "P001", "--trial", "0", "-o", (folder / "gaze.csv").string()}));
  const std::string recording = read_file(folder / "gaze.csv");
  EXPECT_EQ(std::count(recording.begin(), recording.end(), '\n'), samples + 1) << "and a title";
  EXPECT_THAT(recording, StartsWith("time_ns,x,y,z,valid\n0,"));

  const std::string replay = "recording = \"gaze.csv\"\n" + tracker_profile("recorded", 120);
  const auto profile = folder.write("replay.toml", replay);
  const ProgramResult watched =
      succeeded(run_foveola({"tracker", "watch", profile.string(), "--seconds", "1", "--json"}));
  EXPECT_NEAR(nlohmann::json::parse(watched.output).at("rate_hz").get<double>(), 120.0, 0.1);

  EXPECT_EQ(run_foveola({"study", "gaze", (folder / "study.sqlite").string(), "--participant",
                         "P009", "--trial", "0", "-o", (folder / "none.csv").string()})
                .exit_code,
            1);
}

}  // namespace
}  // namespace foveola::test
