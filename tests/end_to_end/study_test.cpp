// From a protocol to a report, with the built program, and the results read back.
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include "renderer/base/files.h"
#include "study/record/study_records.h"
#include "tests/end_to_end/program.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using testing::HasSubstr;

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

std::string query(const fs::path& path, const std::string& sql) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  sqlite3_stmt* statement = nullptr;
  EXPECT_EQ(sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr), SQLITE_OK);
  std::string value;
  if (sqlite3_step(statement) == SQLITE_ROW) {
    value = reinterpret_cast<const char*>(sqlite3_column_text(statement, 0));
  }
  sqlite3_finalize(statement);
  sqlite3_close(database);
  return value;
}

TEST(Study, GoesFromAProtocolToAReport) {
  const TemporaryFolder folder;
  write_file(folder / "small.toml", small_protocol);
  const fs::path database = folder / "study.sqlite";
  const ProgramResult simulated =
      run_foveola({"study", "simulate", (folder / "small.toml").string(), "--db", database.string(),
                   "--participants", "2", "--seed", "5", "--json"});
  ASSERT_EQ(simulated.exit_code, 0) << simulated.errors;

  EXPECT_EQ(query(database, "PRAGMA journal_mode"), "wal");
  EXPECT_EQ(query(database, "PRAGMA integrity_check"), "ok");
  const study::StudyRecords records = study::read_study(database);
  ASSERT_EQ(records.sessions.size(), 2U);
  EXPECT_EQ(records.sessions[0].kind, "simulated");
  EXPECT_EQ(records.sessions[0].state, "completed");
  ASSERT_EQ(records.trials.size(), 6U);
  for (const study::TrialRow& trial : records.trials) {
    ASSERT_TRUE(trial.outline_s && trial.material_s && trial.artifact_rating);
    EXPECT_GT(*trial.outline_s, 0.0);
    EXPECT_GE(*trial.material_s, *trial.outline_s);
    EXPECT_GE(*trial.artifact_rating, 1);
    EXPECT_LE(*trial.artifact_rating, 5);
  }

  const ProgramResult analysed =
      run_foveola({"analyze", database.string(), "-o", (folder / "out").string()});
  ASSERT_EQ(analysed.exit_code, 0) << analysed.errors;
  const std::string report = read_file(folder / "out" / "report.html");
  EXPECT_THAT(report, HasSubstr("imulated"));
  EXPECT_THAT(report, HasSubstr("<svg"));
  EXPECT_THAT(report, HasSubstr(records.protocol_sha256));
}

TEST(Study, TheSameSeedGivesTheSameMarks) {
  const TemporaryFolder folder;
  write_file(folder / "small.toml", small_protocol);
  const auto marks = [&](const std::string& name, const std::string& seed,
                         const std::string& threads) {
    const ProgramResult result = run_foveola({"study", "simulate", (folder / "small.toml").string(),
                                              "--db", (folder / name).string(), "--participants",
                                              "1", "--seed", seed, "--threads", threads});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    std::vector<std::tuple<std::string, double, double, int>> values;
    for (const study::TrialRow& t : study::read_study(folder / name).trials) {
      values.emplace_back(t.method, t.outline_s.value_or(-1), t.material_s.value_or(-1),
                          t.artifact_rating.value_or(-1));
    }
    return values;
  };
  const auto first = marks("a.sqlite", "5", "1");
  EXPECT_EQ(first, marks("b.sqlite", "5", "2"));
  EXPECT_NE(first, marks("c.sqlite", "6", "2"));
}

}  // namespace
}  // namespace foveola::test
