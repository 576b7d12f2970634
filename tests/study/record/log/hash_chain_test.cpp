#include "study/record/log/hash_chain.h"

#include <array>
#include <cstdio>

#include <SQLiteCpp/SQLiteCpp.h>

#include "tests/matchers.h"
#include "tests/study/record/small_study.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

// Python: hashlib.sha256('\n'.join(['0' * 64, '7', '-5', '2026-11-21T09:30:00.123Z', 'marked',
// '{"time_ns":1}']).encode()).hexdigest(), and in schema 5 with '3', '2', '{}' behind them, or
// with three empty texts.
TEST(HashChain, IsOfTheLinesThatTheSchemaNames) {
  LogLine line = {.sequence = 7,
                  .time_ns = -5,
                  .utc = "2026-11-21T09:30:00.123Z",
                  .type = "marked",
                  .payload = R"({"time_ns":1})",
                  .trial = 3,
                  .attempt = 2,
                  .measured = "{}"};
  const std::string before(64, '0');
  EXPECT_EQ(hash_of(before, line, 4),
            "cf27bac9047241d53f7af7b92622a2030c1faa3cf4da8c014fb0185868c8a8fd");
  EXPECT_EQ(hash_of(before, line, 5),
            "993df92c7751a2c5ba0fbca0d5a67ae3177a60982b7e4fc97fc4086a63a7a44c");
  line.trial = line.attempt = std::nullopt;
  line.measured.clear();
  EXPECT_EQ(hash_of(before, line, 5),
            "33b77c8df153dfaf424c26cf821cdf990df6003bc27c3da11cc8c72544c44fe8");
}

/// What hash_chain.py, which knows nothing of this program, says of the file.
std::string outsiders_opinion(const fs::path& path) {
  const std::string command =
      "python3 " TEST_DATA_DIR "/../study/record/hash_chain.py " + path.string() + " 2>&1";
  FILE* pipe = ::popen(command.c_str(), "r");
  std::string output;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), line.size(), pipe) != nullptr) {
    output += line.data();
  }
  ::pclose(pipe);
  return output;
}

TEST(HashChain, CanBeCheckedByAnOutsider) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  {
    StudyStore store(path, thorough_protocol());
    SessionFacts facts = facts_of("Pü \"1\"\t");
    facts.devices = R"({"display":"Größe"})";
    PlayedSession session(store, facts, small_plan(), thorough_protocol());
    session.begin_thoroughly();
    session.choose_and_start(ms(20), "Väse/\\");
    run_thorough_session(store, "P02");
  }
  const std::vector<std::string> last =
      query_column(path,
                   "SELECT hash FROM event AS e WHERE sequence = (SELECT max(sequence) FROM event"
                   " WHERE session = e.session) ORDER BY session");
  EXPECT_EQ(outsiders_opinion(path),
            "Pü \"1\"\t 10 " + last.at(0) + "\nP02 " +
                query(path, "SELECT count(*) FROM event WHERE session = 2") + " " + last.at(1) +
                "\n");
  tamper(path, "UPDATE planned_trial SET method = 'fv' WHERE session = 2 AND trial = 0");
  EXPECT_THAT(outsiders_opinion(path), HasSubstr("P02: event 1 is not what was written"));
}

TEST(HashChain, CoversEveryFactAndEveryEvent) {
  const TemporaryFolder folder;
  const fs::path path = folder / "study.sqlite";
  write_thorough_session(path, "P01");
  const std::vector<std::string> changes = {
      "UPDATE study SET protocol_title = 'x'",
      "UPDATE study_scene SET position = position + 7",
      "UPDATE study_method SET position = position + 7",
      "UPDATE study_method_file SET file_name = 'x'",
      "UPDATE study_profile SET name = name || 'x'",
      "UPDATE study_mark SET position = position + 7",
      "UPDATE study_rating SET question = '{}'",
      "UPDATE session SET participant = 'x'",
      "UPDATE session SET uuid = upper(uuid)",
      "UPDATE session SET kind = 'human'",
      "UPDATE session SET seed = '1'",
      "UPDATE session SET design_row = NULL",
      "UPDATE session SET started_utc = 'x'",
      "UPDATE session SET devices = '{\"a\":1}'",
      "UPDATE session SET program_version = 'x'",
      "UPDATE session SET cores = 3",
      "UPDATE session SET migrated_from = 3",
      "UPDATE session SET study_created_utc = 'x'",
      "UPDATE session_scene SET shown_as = '{\"a\":1}'",
      "UPDATE planned_trial SET scene_position = 5 WHERE trial = 0",
      "UPDATE planned_step SET times = times + 1 WHERE times IS NOT NULL"};
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  for (const char* guarded :
       {"study", "study_scene", "study_method", "study_method_file", "study_profile", "study_mark",
        "study_rating", "session_scene", "planned_trial", "planned_step"}) {
    database.exec(std::string("DROP TRIGGER ") + guarded + "_is_fixed");
  }
  database.exec("DROP TRIGGER session_changes_state_only; DROP TRIGGER session_ends_once");
  PreparedStatements statements(database);
  const std::string whole = hash_before_events(statements, 1);
  for (const std::string& change : changes) {
    const SQLite::Transaction rolled_back(database);
    ASSERT_GT(database.exec(change), 0) << change;
    EXPECT_NE(hash_before_events(statements, 1), whole) << change;
  }
  EXPECT_EQ(hash_before_events(statements, 1), whole);
}

}  // namespace
}  // namespace foveola::study
