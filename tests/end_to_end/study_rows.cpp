#include "tests/end_to_end/study_rows.h"

#include <stdexcept>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "tests/waiting.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

/// Who closes a study's file, or goes on with it after a kill, keeps readers out meanwhile.
constexpr int patience_ms =
    static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(patience).count());

}  // namespace

std::optional<Rows> rows_of(const fs::path& database, const std::string& sql) {
  sqlite3* connection = nullptr;
  sqlite3_stmt* statement = nullptr;
  std::optional<Rows> rows;
  if (fs::exists(database) &&
      sqlite3_open_v2(database.c_str(), &connection, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK &&
      sqlite3_busy_timeout(connection, patience_ms) == SQLITE_OK &&
      sqlite3_prepare_v2(connection, sql.c_str(), -1, &statement, nullptr) == SQLITE_OK) {
    rows.emplace();
    int result = sqlite3_step(statement);
    for (; result == SQLITE_ROW; result = sqlite3_step(statement)) {
      std::string row;
      for (int column = 0; column < sqlite3_column_count(statement); ++column) {
        const unsigned char* text = sqlite3_column_text(statement, column);
        row += (column > 0 ? "|" : "") +
               std::string(text != nullptr ? reinterpret_cast<const char*>(text) : "-");
      }
      rows->push_back(std::move(row));
    }
    if (result != SQLITE_DONE) {
      rows.reset();
    }
  }
  sqlite3_finalize(statement);
  sqlite3_close(connection);
  return rows;
}

Rows all_rows_of(const fs::path& database, const std::string& sql) {
  std::optional<Rows> rows = rows_of(database, sql);
  if (!rows) {
    throw std::runtime_error(database.string() + " has no answer to: " + sql);
  }
  return *std::move(rows);
}

std::string value_of(const fs::path& database, const std::string& sql) {
  const Rows rows = all_rows_of(database, sql);
  return rows.empty() ? "" : rows.front();
}

Rows log_of(const fs::path& database) {
  return rows_of(database,
                 "SELECT participant, sequence, time_ns, utc, type, payload FROM event"
                 " JOIN session ON session.id = event.session ORDER BY 1, 2")
      .value_or(Rows{});
}

int count_events(const fs::path& database) {
  const std::optional<Rows> rows = rows_of(database, "SELECT count(*) FROM event");
  return rows && !rows->empty() ? std::stoi(rows->front()) : 0;
}

Rows results_of(const fs::path& database) {
  const std::string last_attempt =
      " JOIN session ON session.id = session_of WHERE attempt = (SELECT max(attempt) FROM attempt"
      " WHERE attempt.session = session_of AND attempt.trial = trial_of) ORDER BY 1, 2, 3, 4, 5";
  Rows results;
  for (const std::string& sql : std::vector<std::string>{
           "SELECT participant, design_row, state FROM session ORDER BY 1",
           "SELECT participant, trial, planned_trial.kind, scene, method FROM planned_trial"
           " JOIN session ON session.id = session ORDER BY 1, 2",
           "SELECT participant, trial_of, object, outcome FROM (SELECT session AS session_of,"
           " trial AS trial_of, attempt, object, outcome, 0 AS last FROM attempt)" +
               last_attempt.substr(0, last_attempt.find(" ORDER")) + " ORDER BY 1, 2",
           "SELECT participant, trial_of, mark, time_ns, censored FROM (SELECT session AS"
           " session_of, trial AS trial_of, attempt, kind AS mark, time_ns, censored FROM mark)" +
               last_attempt,
           "SELECT participant, trial_of, question, quote(value), 0 FROM (SELECT session AS"
           " session_of, trial AS trial_of, attempt, question, value FROM rating)" +
               last_attempt,
           "SELECT participant, trial_of, frame, film_sha256, 0 FROM (SELECT session AS session_of,"
           " trial AS trial_of, attempt, frame, film_sha256 FROM film_hash)" +
               last_attempt,
           "SELECT participant, step, questionnaire, question, quote(number), text"
           " FROM questionnaire_answer JOIN session ON session.id = session ORDER BY 1, 2, 4",
           "SELECT participant, number, pressed_ns - shown_ns, early FROM reaction"
           " JOIN session ON session.id = session ORDER BY 1, 2",
           "SELECT participant, run, quote(accuracy_deg), quote(precision_rms_deg),"
           " quote(data_loss), passed FROM gaze_run JOIN session ON session.id = session"
           " ORDER BY 1, 2"}) {
    const std::optional<Rows> rows = rows_of(database, sql);
    EXPECT_TRUE(rows && !rows->empty()) << sql;
    results.insert(results.end(), rows->begin(), rows->end());
    results.emplace_back("--");
  }
  return results;
}

}  // namespace foveola::test
