#include "study/record/study_records.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "study/record/database.h"
#include "study/record/schema.h"
#include "study/record/simulated_part.h"
#include "study/record/stored_number.h"
#include "study/record/trial_rows.h"

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

/// The text of a questionnaire's file that the protocol names, as it was when the study began.
std::string recorded_file(SQLite::Database& database, const std::string& name) {
  SQLite::Statement row(
      database, "SELECT toml FROM study_profile WHERE device = 'questionnaire' AND name = ?");
  row.bind(1, name);
  if (!row.executeStep()) {
    throw std::runtime_error("the study's file does not hold it");
  }
  return row.getColumn(0).getString();
}

std::string profile_name(SQLite::Database& database, const char* device) {
  SQLite::Statement row(database, "SELECT name FROM study_profile WHERE device = ?");
  row.bind(1, device);
  return row.executeStep() ? row.getColumn(0).getString() : "";
}

void read_protocol(SQLite::Database& database, const fs::path& path, StudyRecords& records) {
  SQLite::Statement study(database,
                          "SELECT protocol_name, protocol_title, protocol_sha256, protocol_text"
                          " FROM study");
  study.executeStep();
  records.protocol =
      read_measured_part(study.getColumn("protocol_text").getString(),
                         fmt::format("the protocol in {}", path.string()),
                         [&](const std::string& name) { return recorded_file(database, name); });
  records.protocol.name = study.getColumn("protocol_name").getString();
  records.protocol.title = study.getColumn("protocol_title").getString();
  records.protocol.sha256 = study.getColumn("protocol_sha256").getString();
  records.display_profile = profile_name(database, "display");
  records.tracker_profile = profile_name(database, "tracker");
  records.scenes = read_names(database, "SELECT name FROM study_scene ORDER BY position");
  records.methods = read_names(database, "SELECT name FROM study_method ORDER BY position");
  records.measures = trial_measures(records.protocol.marks, records.protocol.ratings);
  if (schema_version_of(database) >= 5) {
    add_response_measures(
        read_names(database,
                   "SELECT question FROM rating WHERE response_ns IS NOT NULL UNION SELECT ''"
                   " FROM attempt WHERE looked_around_ns IS NOT NULL"),
        records.measures);
  }
}

std::optional<int> optional_integer(SQLite::Statement& row, const char* column) {
  const SQLite::Column value = row.getColumn(column);
  return value.isNull() ? std::nullopt : std::optional(whole_number<int>(value));
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

/// Returns those whose data are to be read.
SessionIndices read_sessions(SQLite::Database& database, WithdrawnSessions withdrawn,
                             StudyRecords& records) {
  SessionIndices with_data;
  SQLite::Statement rows(
      database,
      "SELECT id, participant, kind, state, design_row,"
      " coalesce((SELECT payload ->> 'reason' FROM event WHERE event.session = session.id"
      "  AND type = 'excluded' AND state = 'excluded' ORDER BY sequence DESC LIMIT 1), '')"
      " AS reason FROM session ORDER BY id");
  while (rows.executeStep()) {
    const std::string state = rows.getColumn("state").getString();
    if (state != "withdrawn" || withdrawn == WithdrawnSessions::with_data) {
      with_data.emplace(rows.getColumn("id").getInt64(),
                        static_cast<std::uint32_t>(records.sessions.size()));
    }
    records.sessions.push_back({.participant = rows.getColumn("participant").getString(),
                                .kind = rows.getColumn("kind").getString(),
                                .state = state,
                                .design_row = optional_integer(rows, "design_row"),
                                .reason = rows.getColumn("reason").getString()});
  }
  return with_data;
}

std::optional<SimulationFacts> read_simulation(SQLite::Database& database) {
  SQLite::Statement rows(
      database,
      "SELECT devices ->> '$.simulation.scale' AS scale,"
      " devices ->> '$.simulation.samples_per_second' AS samples_per_second,"
      " devices ->> '$.simulation.predicted' AS predicted,"
      // Earlier versions called it "plant".
      " coalesce(nullif(coalesce(devices ->> '$.simulation.injected',"
      " devices ->> '$.simulation.plant'), 'none'), '') AS injected FROM session"
      " WHERE kind = 'simulated' AND devices -> '$.simulation' IS NOT NULL LIMIT 1");
  if (!rows.executeStep()) {
    return std::nullopt;
  }
  const SQLite::Column speed = rows.getColumn("samples_per_second");
  const std::optional<SimulatedWhole> whole = whole_of(database);
  return SimulationFacts{
      .scale = rows.getColumn("scale").getDouble(),
      .samples_per_second = speed.isNull() ? std::nullopt : std::optional(speed.getDouble()),
      .predicted = rows.getColumn("predicted").getInt() == 1,
      .injected = rows.getColumn("injected").getString(),
      .whole_participants = whole ? std::optional(whole->participants) : std::nullopt};
}

void read_answers(SQLite::Database& database, const SessionIndices& sessions, WordIndices& words,
                  StudyRecords& records) {
  const bool has_times = schema_version_of(database) >= 5;
  SQLite::Statement rows(
      database, fmt::format("SELECT session, step, questionnaire, question, number, text, {} / 1e9"
                            " FROM questionnaire_answer ORDER BY rowid",
                            has_times ? "response_ns" : "NULL"));
  while (rows.executeStep()) {
    const auto session = sessions.find(rows.getColumn(0).getInt64());
    if (session == sessions.end()) {
      continue;
    }
    const SQLite::Column number = rows.getColumn(4);
    const SQLite::Column response = rows.getColumn(6);
    records.answers.push_back(
        {.session = session->second,
         .step = whole_number<int>(rows.getColumn(1)),
         .questionnaire = words.index_of(rows.getColumn(2).getString()),
         .question = words.index_of(rows.getColumn(3).getString()),
         .value = number.isNull()
                      ? Value{.state = Value::State::in_words,
                              .words = words.index_of(rows.getColumn(5).getString())}
                      : Value{.state = Value::State::measured, .number = finite_number(number)},
         .response_s = response.isNull() ? std::nullopt : std::optional(finite_number(response))});
  }
}

/// All queries see the same moment of a study that is being written.
StudyRecords read_records(SQLite::Database& database, const fs::path& path,
                          WithdrawnSessions withdrawn) {
  const SQLite::Transaction moment(database);
  StudyRecords records;
  read_protocol(database, path, records);
  const SessionIndices sessions = read_sessions(database, withdrawn, records);
  records.simulation = read_simulation(database);
  records.amended = read_amended(database);
  records.programs = session_programs(database);
  WordIndices words(records.words);
  read_trial_rows(database, sessions, words, records);
  read_answers(database, sessions, words, records);
  return records;
}

}  // namespace

bool StudyRecords::has_simulated() const {
  return std::ranges::any_of(sessions,
                             [](const SessionRow& row) { return row.kind == "simulated"; });
}

StudyRecords read_study(const fs::path& path, WithdrawnSessions withdrawn) {
  StudyRecords records;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    records = read_records(database, path, withdrawn);
  });
  return records;
}

}  // namespace foveola::study
