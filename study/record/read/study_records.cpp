#include "study/record/read/study_records.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/schema.h"
#include "study/record/setup/simulated_part.h"
#include "study/record/sqlite/damage_remedy.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/stored_number.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// The index in StudyRecords::sessions of each session whose data are read, by its row id.
using SessionIndices = std::unordered_map<std::int64_t, std::uint32_t>;

/// Keeps each text once in StudyRecords::words, the empty one first.
class WordIndices {
 public:
  /// `words` must outlive it.
  explicit WordIndices(std::vector<std::string>& words);
  std::uint32_t index_of(const std::string& text);

 private:
  std::vector<std::string>& words_;
  std::unordered_map<std::string, std::uint32_t> indices_;
};

WordIndices::WordIndices(std::vector<std::string>& words) : words_(words) {
  words_.assign(1, {});
  indices_.emplace("", 0);
}

std::uint32_t WordIndices::index_of(const std::string& text) {
  const auto [known, is_new] = indices_.emplace(text, static_cast<std::uint32_t>(words_.size()));
  if (is_new) {
    words_.push_back(text);
  }
  return known->second;
}

using Positions = std::unordered_map<std::string, std::size_t>;

Positions positions_of(const std::vector<std::string>& names) {
  Positions positions;
  for (const std::string& name : names) {
    positions.emplace(name, positions.size());
  }
  return positions;
}

/// Throws Error for a name that is not among them, which the file's foreign keys exclude.
std::uint16_t position_of(const Positions& positions, const std::string& name, const char* what) {
  const auto found = positions.find(name);
  if (found == positions.end() || !std::in_range<std::uint16_t>(found->second)) {
    throw Error(fmt::format("the {} '{}' of a planned trial", what, name),
                "is not one of the study's", damage_remedy);
  }
  return static_cast<std::uint16_t>(found->second);
}

TrialKind trial_kind_of(const std::string& name) {
  constexpr std::array kinds = {TrialKind::practice, TrialKind::catch_trial};
  for (const TrialKind kind : kinds) {
    if (name == name_of(kind)) {
      return kind;
    }
  }
  return TrialKind::test;
}

class TrialReader {
 public:
  TrialReader(SQLite::Database& database, const SessionIndices& sessions, WordIndices& words,
              StudyRecords& records)
      : database_(database), sessions_(sessions), words_(words), records_(records) {
    for (const Measure& measure : records.measures) {
      measures_.emplace(measure.id(), measures_.size());
    }
  }

  void read() {
    read_rows();
    records_.values.assign(records_.trials.size() * records_.measures.size(), Value{});
    read_values(
        "SELECT session, trial, attempt, kind, time_ns / 1e9, censored FROM mark"
        " ORDER BY session, trial, attempt");
    read_values(
        "SELECT session, trial, attempt, question, value, 0 FROM rating"
        " ORDER BY session, trial, attempt");
    if (schema_version_of(database_) >= 5) {
      read_values(
          fmt::format("SELECT session, trial, attempt, question || '{}', response_ns / 1e9, 0"
                      " FROM rating WHERE response_ns IS NOT NULL"
                      " ORDER BY session, trial, attempt",
                      response_suffix));
      read_values(
          fmt::format("SELECT session, trial, attempt, '{}', looked_around_ns / 1e9, 0"
                      " FROM attempt WHERE looked_around_ns IS NOT NULL"
                      " ORDER BY session, trial, attempt",
                      looking_around_id));
    }
  }

 private:
  using Key = std::tuple<std::uint32_t, std::uint32_t, int>;  ///< Session, trial, attempt.

  static Key key_of(const TrialRow& row) { return {row.session, row.trial, row.attempt}; }

  void read_rows() {
    const Positions scenes = positions_of(records_.scenes);
    const Positions methods = positions_of(records_.methods);
    SQLite::Statement row(
        database_,
        "SELECT planned_trial.session, planned_trial.trial, planned_trial.kind, scene, method,"
        " scene_position, method_position, coalesce(attempt, 0), coalesce(object, ''),"
        " coalesce(outcome, '')"
        " FROM planned_trial LEFT JOIN attempt ON attempt.session = planned_trial.session"
        "  AND attempt.trial = planned_trial.trial"
        " ORDER BY planned_trial.session, planned_trial.trial, attempt");
    while (row.executeStep()) {
      const auto session = sessions_.find(row.getColumn(0).getInt64());
      if (session == sessions_.end()) {
        continue;
      }
      const TrialKind kind = trial_kind_of(row.getColumn(2).getString());
      const auto position = [&](int column, const std::vector<std::string>& list) {
        return kind == TrialKind::test ? place_in<std::uint16_t>(row.getColumn(column), list.size())
                                       : std::uint16_t{0};
      };
      const TrialRow trial{.session = session->second,
                           .trial = whole_number<std::uint32_t>(row.getColumn(1)),
                           .kind = kind,
                           .scene = position_of(scenes, row.getColumn(3).getString(), "scene"),
                           .method = position_of(methods, row.getColumn(4).getString(), "method"),
                           .scene_position = position(5, records_.scenes),
                           .method_position = position(6, records_.methods),
                           .attempt = whole_number<std::uint16_t>(row.getColumn(7)),
                           .object = words_.index_of(row.getColumn(8).getString()),
                           .outcome = words_.index_of(row.getColumn(9).getString())};
      if (!records_.trials.empty()) {
        TrialRow& before = records_.trials.back();
        before.counts = before.session != trial.session || before.trial != trial.trial;
      }
      records_.trials.push_back(trial);
    }
  }

  /// The query's columns: session, trial, attempt, measure, value, censored; in the order of the
  /// trials' rows, so that both are read once.
  void read_values(const std::string& sql) {
    SQLite::Statement row(database_, sql);
    std::size_t at = 0;
    while (row.executeStep()) {
      const auto session = sessions_.find(row.getColumn(0).getInt64());
      const auto measure = measures_.find(row.getColumn(3).getString());
      if (session == sessions_.end() || measure == measures_.end()) {
        continue;
      }
      const Key key{session->second, whole_number<std::uint32_t>(row.getColumn(1)),
                    whole_number<int>(row.getColumn(2))};
      while (at < records_.trials.size() && key_of(records_.trials[at]) < key) {
        ++at;
      }
      if (at < records_.trials.size() && key_of(records_.trials[at]) == key) {
        records_.values[at * records_.measures.size() + measure->second] =
            value_of(row.getColumn(4), row.getColumn(5).getInt() == 1);
      }
    }
  }

  Value value_of(const SQLite::Column& column, bool is_censored) {
    if (column.isText()) {
      return {.state = Value::State::in_words, .words = words_.index_of(column.getString())};
    }
    return {.state = is_censored ? Value::State::right_censored : Value::State::measured,
            .number = finite_number(column)};
  }

  SQLite::Database& database_;
  const SessionIndices& sessions_;
  WordIndices& words_;
  StudyRecords& records_;
  Positions measures_;
};

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
  const std::optional<ShardedStudy> whole = read_sharded_study(database);
  return SimulationFacts{
      .scale = rows.getColumn("scale").getDouble(),
      .samples_per_second = speed.isNull() ? std::nullopt : std::optional(speed.getDouble()),
      .predicted = rows.getColumn("predicted").getInt() == 1,
      .injected = rows.getColumn("injected").getString(),
      .whole_participants = whole ? std::optional(whole->participants) : std::nullopt};
}

void read_answers(SQLite::Database& database, const SessionIndices& sessions, WordIndices& words,
                  StudyRecords& records) {
  // Both give them in the order in which they were given: a table by its rows, a view by its own.
  const bool is_table = schema_version_of(database) < 5;
  SQLite::Statement rows(
      database,
      fmt::format("SELECT session, step, questionnaire, question, number, text, {}"
                  " FROM questionnaire_answer {}",
                  is_table ? "NULL" : "response_ns / 1e9", is_table ? "ORDER BY rowid" : ""));
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
  TrialReader(database, sessions, words, records).read();
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
    records.file = path.string();
  });
  return records;
}

}  // namespace foveola::study
