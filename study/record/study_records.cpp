#include "study/record/study_records.h"

#include <algorithm>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>

#include "study/record/database.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

std::vector<std::string> read_names(SQLite::Database& database, const char* sql) {
  std::vector<std::string> names;
  SQLite::Statement rows(database, sql);
  while (rows.executeStep()) {
    names.push_back(rows.getColumn(0).getString());
  }
  return names;
}

void read_protocol(SQLite::Database& database, StudyRecords& records) {
  SQLite::Statement study(database,
                          "SELECT protocol_name, protocol_title, protocol_sha256, protocol_text"
                          " FROM study");
  study.executeStep();
  records.protocol_name = study.getColumn("protocol_name").getString();
  records.protocol_title = study.getColumn("protocol_title").getString();
  records.protocol_sha256 = study.getColumn("protocol_sha256").getString();
  records.protocol_text = study.getColumn("protocol_text").getString();
  records.scenes = read_names(database, "SELECT name FROM study_scene ORDER BY position");
  records.methods = read_names(database, "SELECT name FROM study_method ORDER BY position");
}

std::optional<double> optional_number(SQLite::Statement& row, const char* column) {
  const SQLite::Column value = row.getColumn(column);
  return value.isNull() ? std::nullopt : std::optional(value.getDouble());
}

std::optional<int> optional_integer(SQLite::Statement& row, const char* column) {
  const SQLite::Column value = row.getColumn(column);
  return value.isNull() ? std::nullopt : std::optional(value.getInt());
}

std::vector<AmendedSession> read_amended(SQLite::Database& database) {
  std::vector<AmendedSession> amended;
  SQLite::Statement notes(database,
                          "SELECT participant, text FROM note JOIN session ON session.id = session"
                          " ORDER BY session, sequence");
  while (notes.executeStep()) {
    if (std::optional<Amendment> amendment = amendment_in(notes.getColumn(1).getString())) {
      AmendedSession session{.participant = notes.getColumn(0).getString(),
                             .amendment = std::move(*amendment)};
      if (std::ranges::find(amended, session) == amended.end()) {
        amended.push_back(std::move(session));
      }
    }
  }
  return amended;
}

std::vector<SessionRow> read_sessions(SQLite::Database& database) {
  std::vector<SessionRow> sessions;
  SQLite::Statement rows(
      database,
      "SELECT participant, kind, state, design_row, coalesce(payload ->> 'reason', '') AS "
      "reason"
      " FROM session LEFT JOIN event ON event.session = session.id AND type = 'excluded'"
      " ORDER BY id");
  while (rows.executeStep()) {
    sessions.push_back({.participant = rows.getColumn("participant").getString(),
                        .kind = rows.getColumn("kind").getString(),
                        .state = rows.getColumn("state").getString(),
                        .design_row = optional_integer(rows, "design_row"),
                        .reason = rows.getColumn("reason").getString()});
  }
  return sessions;
}

std::optional<SimulationFacts> read_simulation(SQLite::Database& database) {
  SQLite::Statement rows(
      database,
      "SELECT devices ->> '$.simulation.scale' AS scale,"
      " devices ->> '$.simulation.predicted' AS predicted,"
      // Earlier versions called it "plant".
      " coalesce(nullif(coalesce(devices ->> '$.simulation.injected',"
      " devices ->> '$.simulation.plant'), 'none'), '') AS injected FROM session"
      " WHERE kind = 'simulated' AND devices -> '$.simulation' IS NOT NULL LIMIT 1");
  if (!rows.executeStep()) {
    return std::nullopt;
  }
  return SimulationFacts{.scale = rows.getColumn("scale").getDouble(),
                         .predicted = rows.getColumn("predicted").getInt() == 1,
                         .injected = rows.getColumn("injected").getString()};
}

TrialRow read_trial(SQLite::Statement& row) {
  return {.participant = row.getColumn("participant").getString(),
          .scene = row.getColumn("scene").getString(),
          .method = row.getColumn("method").getString(),
          .scene_position = row.getColumn("scene_position").getInt(),
          .method_position = row.getColumn("method_position").getInt(),
          .attempts = row.getColumn("attempts").getInt(),
          .outline_s = optional_number(row, "outline_s"),
          .material_s = optional_number(row, "material_s"),
          .outline_censored = optional_integer(row, "outline_censored") == 1,
          .material_censored = optional_integer(row, "material_censored") == 1,
          .artifact_rating = optional_integer(row, "artifacts")};
}

std::vector<TrialRow> read_trials(SQLite::Database& database) {
  std::vector<TrialRow> trials;
  SQLite::Statement rows(database,
                         "SELECT * FROM trial_result WHERE session_state <> 'withdrawn'"
                         " ORDER BY session, trial");
  while (rows.executeStep()) {
    trials.push_back(read_trial(rows));
  }
  return trials;
}

std::vector<BackgroundRow> read_background(SQLite::Database& database) {
  std::vector<BackgroundRow> background;
  SQLite::Statement rows(database,
                         "SELECT participant, question, number"
                         " FROM questionnaire_answer JOIN session ON session.id = session"
                         " WHERE questionnaire = 'background' AND number IS NOT NULL"
                         "  AND state <> 'withdrawn' ORDER BY questionnaire_answer.rowid");
  while (rows.executeStep()) {
    background.push_back({.participant = rows.getColumn("participant").getString(),
                          .question = rows.getColumn("question").getString(),
                          .value = rows.getColumn("number").getDouble()});
  }
  return background;
}

/// All queries see the same moment of a study that is being written.
StudyRecords read_records(SQLite::Database& database) {
  const SQLite::Transaction moment(database);
  StudyRecords records;
  read_protocol(database, records);
  records.sessions = read_sessions(database);
  records.simulation = read_simulation(database);
  records.amended = read_amended(database);
  records.trials = read_trials(database);
  records.background = read_background(database);
  return records;
}

}  // namespace

bool StudyRecords::has_simulated() const {
  return std::ranges::any_of(sessions,
                             [](const SessionRow& row) { return row.kind == "simulated"; });
}

StudyRecords read_study(const fs::path& path) {
  StudyRecords records;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    records = read_records(database);
  });
  return records;
}

}  // namespace foveola::study
