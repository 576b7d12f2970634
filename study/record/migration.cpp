#include "study/record/migration.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "study/record/chunk.h"
#include "study/record/database.h"
#include "study/record/event_log.h"
#include "study/record/gaze_json.h"
#include "study/record/question_json.h"
#include "study/record/schema.h"
#include "study/record/session_rows.h"
#include "study/record/table_rows.h"
#include "study/record/temporary_database.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

constexpr int schema_3 = 3;

/// What every trial of schema 3 asked after its marks.
Question artifacts_question() {
  return {.id = "artifacts",
          .text = "How much did artifacts in the other areas disturb?",
          .kind = QuestionKind::likert,
          .minimum = 1.0,
          .maximum = 5.0,
          .labels = {"none", "not discernible at all"}};
}

void copy_study_tables(SQLite::Database& older, SQLite::Database& target) {
  for (const char* table :
       {"study", "study_scene", "study_method", "study_method_file", "study_profile"}) {
    copy_rows(older, target, table);
  }
  target.exec("INSERT INTO study_mark VALUES (0, 'outline'), (1, 'material')");
  const Question artifacts = artifacts_question();
  SQLite::Statement rating(target, "INSERT INTO study_rating VALUES (0, ?, ?)");
  SQLite::bind(rating, artifacts.id, question_json(artifacts));
  rating.exec();
}

/// One session of the older file.
class OlderSession {
 public:
  OlderSession(SQLite::Database& older, std::int64_t id) : older_(older), id_(id) {}

  /// Writes the session into `target`.
  void bring_to(SQLite::Database& target) {
    const std::vector<LoggedEvent> log = events();
    const std::int64_t session =
        insert_session(target, facts(), origin(), plan_of_session(), agenda());
    PreparedStatements statements(target);
    replay_events(statements, session, recorded_procedure_of(target, session), log);
    bring_chunks(target, session, "frame_chunk", "first_frame", "frame_count");
    bring_chunks(target, session, "gaze_chunk", "first_sample", "sample_count");
  }

 private:
  SQLite::Statement rows(const char* sql) const {
    SQLite::Statement statement(older_, sql);
    statement.bind(1, id_);
    return statement;
  }

  SessionFacts facts() const {
    SQLite::Statement row = rows("SELECT * FROM session WHERE id = ?");
    row.executeStep();
    const auto text = [&](const char* column) { return row.getColumn(column).getString(); };
    const std::string kind = text("kind");
    return {.participant = text("participant"),
            .kind = kind == "human"   ? SessionKind::human
                    : kind == "pilot" ? SessionKind::pilot
                                      : SessionKind::simulated,
            .seed = std::stoull(text("seed")),
            .build = {.version = text("program_version"),
                      .compiler = text("compiler"),
                      .build_type = text("build_type")},
            .machine = {.processor = text("processor"),
                        .cores = row.getColumn("cores").getInt(),
                        .system = text("operating_system")},
            .scenes = scenes()};
  }

  std::vector<ShownScene> scenes() const {
    std::vector<ShownScene> shown;
    SQLite::Statement row = rows("SELECT * FROM session_scene WHERE session = ?");
    while (row.executeStep()) {
      shown.push_back({.name = row.getColumn("scene").getString(),
                       .file_name = row.getColumn("file_name").getString(),
                       .sha256 = row.getColumn("file_sha256").getString(),
                       .shown_as = row.getColumn("shown_as").getString()});
    }
    return shown;
  }

  SessionOrigin origin() const {
    SQLite::Statement row = rows("SELECT uuid, started_utc FROM session WHERE id = ?");
    row.executeStep();
    return {.uuid = row.getColumn("uuid").getString(),
            .started_utc = row.getColumn("started_utc").getString(),
            .migrated_from = schema_3};
  }

  Plan plan_of_session() const {
    Plan plan;
    SQLite::Statement row = rows("SELECT * FROM planned_trial WHERE session = ? ORDER BY trial");
    while (row.executeStep()) {
      plan.push_back({.scene = row.getColumn("scene").getString(),
                      .method = row.getColumn("method").getString(),
                      .scene_position = row.getColumn("scene_position").getInt(),
                      .method_position = row.getColumn("method_position").getInt()});
    }
    return plan;
  }

  /// As every session of schema 3 went.
  Agenda agenda() const {
    Agenda agenda;
    SQLite::Statement validations =
        rows("SELECT payload ->> 'validations' FROM event WHERE session = ? AND sequence = 1");
    if (validations.executeStep() && validations.getColumn(0).getInt() > 0) {
      agenda.emplace_back(ValidationStep{.attempts = validations.getColumn(0).getInt()});
    }
    agenda.emplace_back(QuestionnaireStep{.questionnaire = "background"});
    const std::size_t trials = plan_of_session().size();
    for (std::size_t trial = 0; trial < trials; ++trial) {
      agenda.emplace_back(TrialStep{.trial = trial, .chooses_object = true});
    }
    return agenda;
  }

  std::vector<LoggedEvent> events() const {
    std::vector<LoggedEvent> log;
    SQLite::Statement row = rows("SELECT * FROM event WHERE session = ? ORDER BY sequence");
    while (row.executeStep()) {
      const Nanoseconds time(row.getColumn("time_ns").getInt64());
      const std::string utc = row.getColumn("utc").getString();
      for (Event& event : events_of_today(row)) {
        log.push_back({.time = time, .event = std::move(event), .utc = utc});
      }
    }
    return log;
  }

  /// What one event of schema 3 says today: a trial then began with the choice of its object, or
  /// when it was to be timed again.
  std::vector<Event> events_of_today(SQLite::Statement& row) const {
    const std::string type = row.getColumn("type").getString();
    const auto values = nlohmann::json::parse(row.getColumn("payload").getString());
    const auto time = [&] { return Nanoseconds(values.at("time_ns").get<std::int64_t>()); };
    if (type == "session_started") {
      return {SessionStarted{}};
    }
    if (type == "gaze_validated") {
      return {GazeValidated{.runs = runs(row.getColumn("sequence").getInt64()),
                            .passed = values.at("passed")}};
    }
    if (type == "background_answered") {
      return {background(values)};
    }
    if (type == "object_chosen") {
      return {ObjectChosen{values.at("object")}, TrialStarted{}};
    }
    if (type == "first_frame_presented") {
      return {FirstFramePresented{time()}};
    }
    if (type == "outline_marked" || type == "material_marked") {
      return {Marked{time()}};
    }
    if (type == "timed_out") {
      return {TimedOut{time()}};
    }
    if (type == "artifacts_rated") {
      return {Rated{{{.question = "artifacts", .value = values.at("rating").get<double>()}}}};
    }
    if (type == "retime_requested") {
      return {RetimeRequested{}, TrialStarted{}};
    }
    if (type == "interrupted") {
      return {Interrupted{}};
    }
    if (type == "withdrawn") {
      return {Withdrawn{}};
    }
    throw std::invalid_argument(fmt::format("schema 3 has no event {}", type));
  }

  static QuestionnaireAnswered background(const nlohmann::json& values) {
    QuestionnaireAnswered answered{.questionnaire = "background", .answers = {}};
    const nlohmann::json& answers = values.at("answers");
    for (const nlohmann::json& answer : answers) {
      answered.answers.push_back(
          {.question = answer.at("question"), .value = answer.at("value").get<double>()});
    }
    return answered;
  }

  std::vector<GazeRun> runs(std::int64_t sequence) const {
    std::vector<GazeRun> runs;
    SQLite::Statement row =
        rows("SELECT * FROM gaze_run WHERE session = ?1 AND sequence = ?2 ORDER BY run");
    row.bind(2, sequence);
    while (row.executeStep()) {
      GazeRun run{.quality = {.targets = targets(row.getColumn("run").getInt64()),
                              .data_loss = row.getColumn("data_loss").getDouble(),
                              .figures = figures(row)},
                  .passed = row.getColumn("passed").getInt() != 0};
      if (const SQLite::Column correction = row.getColumn("correction"); !correction.isNull()) {
        run.correction =
            gaze_correction_from(nlohmann::ordered_json::parse(correction.getString()));
      }
      runs.push_back(std::move(run));
    }
    return runs;
  }

  std::vector<TargetQuality> targets(std::int64_t run) const {
    std::vector<TargetQuality> targets;
    SQLite::Statement row =
        rows("SELECT * FROM gaze_target WHERE session = ?1 AND run = ?2 ORDER BY target");
    row.bind(2, run);
    while (row.executeStep()) {
      TargetQuality target{.direction = direction(row, "azimuth_deg", "elevation_deg"),
                           .data_loss = row.getColumn("data_loss").getDouble()};
      if (const std::optional<GazeFigures> seen = figures(row)) {
        target.seen = SeenTarget{
            .mean_gaze = direction(row, "mean_gaze_azimuth_deg", "mean_gaze_elevation_deg"),
            .samples = static_cast<std::size_t>(row.getColumn("samples").getInt64()),
            .figures = *seen};
      }
      targets.push_back(target);
    }
    return targets;
  }

  static Vec3 direction(SQLite::Statement& row, const char* azimuth_deg,
                        const char* elevation_deg) {
    return direction_from({.azimuth_rad = radians(row.getColumn(azimuth_deg).getDouble()),
                           .elevation_rad = radians(row.getColumn(elevation_deg).getDouble())});
  }

  static std::optional<GazeFigures> figures(SQLite::Statement& row) {
    if (row.getColumn("accuracy_deg").isNull()) {
      return std::nullopt;
    }
    return GazeFigures{.accuracy_deg = row.getColumn("accuracy_deg").getDouble(),
                       .precision_rms_deg = row.getColumn("precision_rms_deg").getDouble(),
                       .precision_sd_deg = row.getColumn("precision_sd_deg").getDouble()};
  }

  void bring_chunks(SQLite::Database& target, std::int64_t session, const char* table,
                    const char* first, const char* count) const {
    SQLite::Statement row =
        rows(fmt::format("SELECT *, {} AS first, {} AS count FROM {} WHERE session = ?", first,
                         count, table)
                 .c_str());
    while (row.executeStep()) {
      insert_chunk(target, table,
                   {.session = session,
                    .trial = row.getColumn("trial").getInt64(),
                    .attempt = row.getColumn("attempt").getInt(),
                    .first = row.getColumn("first").getInt64(),
                    .count = row.getColumn("count").getInt64()},
                   row.getColumn("encoding").getString(), row.getColumn("data").getString());
    }
  }

  SQLite::Database& older_;
  std::int64_t id_;
};

Error unreadable(std::int64_t session, const std::string& why) {
  return {fmt::format("session {}", session), fmt::format("cannot be read ({})", why),
          "restore it from a copy"};
}

/// A view in a table's place could make reading it do anything.
void require_tables(SQLite::Database& older) {
  SQLite::Statement strange(
      older, "SELECT count(*) FROM sqlite_schema WHERE type = 'view' AND name <> 'trial_result'");
  strange.executeStep();
  if (strange.getColumn(0).getInt() > 0) {
    throw Error("the study", "has views that are not Foveola's", "restore it from a copy");
  }
}

}  // namespace

void bring_to_this_schema(SQLite::Database& older, SQLite::Database& target) {
  require_tables(older);
  SQLite::Transaction transaction(target);
  target.exec(study_schema());
  copy_study_tables(older, target);
  SQLite::Statement sessions(older, "SELECT id FROM session ORDER BY id");
  while (sessions.executeStep()) {
    const std::int64_t id = sessions.getColumn(0).getInt64();
    try {
      OlderSession(older, id).bring_to(target);
    } catch (const nlohmann::json::exception& fault) {
      throw unreadable(id, fault.what());
    } catch (const std::logic_error& fault) {  // of numbers and names that cannot be
      throw unreadable(id, fault.what());
    }
  }
  transaction.commit();
}

fs::path copy_of_schema(const fs::path& study, int schema) {
  return fmt::format("{}.schema-{}.sqlite", study.string(), schema);
}

void migrate_study(const fs::path& path) {
  fold_in_log(path);
  SQLite::Database older = open_as_it_is(path);
  copy_checked(older, copy_of_schema(path, schema_3));
  const TemporaryDatabase temporary(path);
  {
    SQLite::Database target(temporary.path(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    target.exec("PRAGMA foreign_keys = ON");
    bring_to_this_schema(older, target);
  }
  temporary.replace_final();
}

}  // namespace foveola::study
