#include "study/record/write/session_rows.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <random>
#include <stdexcept>
#include <system_error>
#include <variant>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "study/record/log/question_json.h"
#include "study/record/setup/session_devices.h"
#include "study/record/sqlite/damage_remedy.h"
#include "study/record/sqlite/stored_number.h"

namespace foveola::study {
namespace {

constexpr std::array session_kinds = {"human", "pilot", "simulated"};
constexpr std::array trial_kinds = {TrialKind::test, TrialKind::practice, TrialKind::catch_trial};

Error unknown_word(std::int64_t session, const std::string& word) {
  return {fmt::format("session {}", session), fmt::format("its record says \"{}\"", word),
          damage_remedy};
}

SessionKind session_kind_named(std::int64_t session, const std::string& name) {
  const auto* found = std::find(session_kinds.begin(), session_kinds.end(), name);
  if (found == session_kinds.end()) {
    throw unknown_word(session, name);
  }
  return static_cast<SessionKind>(found - session_kinds.begin());
}

TrialKind trial_kind_named(std::int64_t session, const std::string& name) {
  const auto* found = std::find_if(trial_kinds.begin(), trial_kinds.end(),
                                   [&](TrialKind kind) { return name == name_of(kind); });
  if (found == trial_kinds.end()) {
    throw unknown_word(session, name);
  }
  return *found;
}

std::uint64_t seed_from(std::int64_t session, const std::string& digits) {
  std::uint64_t seed = 0;
  const char* end = digits.data() + digits.size();
  const auto [rest, fault] = std::from_chars(digits.data(), end, seed);
  if (rest != end || fault != std::errc()) {
    throw unknown_word(session, digits);
  }
  return seed;
}

Phase phase_named(std::int64_t session, const std::string& name) {
  for (int i = 0; i <= static_cast<int>(Phase::refused); ++i) {
    if (name == name_of(static_cast<Phase>(i))) {
      return static_cast<Phase>(i);
    }
  }
  throw unknown_word(session, name);
}

std::int64_t insert_facts(SQLite::Database& database, const SessionFacts& facts,
                          const SessionOrigin& origin) {
  SQLite::Statement session(
      database,
      "INSERT INTO session (uuid, participant, kind, seed, started_utc, program_version, compiler,"
      "  build_type, processor, cores, operating_system, devices, design_row, study_created_utc,"
      "  state)"
      " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, (SELECT created_utc FROM study), "
      "'created')");
  SQLite::bind(session, origin.uuid, facts.participant, name_of(facts.kind),
               std::to_string(facts.seed), origin.started_utc, facts.build.version,
               facts.build.compiler, facts.build.build_type, facts.machine.processor,
               facts.machine.cores, facts.machine.system, with_renderer(facts.devices, facts.build),
               facts.design_row);
  session.exec();
  return database.getLastInsertRowid();
}

void insert_scenes(SQLite::Database& database, std::int64_t session,
                   const std::vector<ShownScene>& scenes) {
  for (const ShownScene& scene : scenes) {
    SQLite::Statement row(database, "INSERT INTO session_scene VALUES (?, ?, ?, ?, ?)");
    SQLite::bind(row, session, scene.name, scene.file_name, scene.sha256, scene.shown_as);
    row.exec();
  }
}

void insert_plan(SQLite::Database& database, std::int64_t session, const Plan& plan) {
  for (std::size_t i = 0; i < plan.size(); ++i) {
    SQLite::Statement row(database, "INSERT INTO planned_trial VALUES (?, ?, ?, ?, ?, ?, ?)");
    SQLite::bind(row, session, static_cast<std::int64_t>(i), name_of(plan[i].kind), plan[i].scene,
                 plan[i].method, plan[i].scene_position, plan[i].method_position);
    row.exec();
  }
}

/// One step of an agenda, as a row.
class StepRow {
 public:
  StepRow(SQLite::Database& database, std::int64_t session, std::size_t step)
      : database_(database), session_(session), step_(static_cast<std::int64_t>(step)) {}

  void operator()(const ConsentStep& /*step*/) const {
    insert("'consent', NULL, NULL, NULL, NULL");
  }
  void operator()(const QuestionnaireStep& step) const {
    insert("'questionnaire', ?, NULL, NULL, NULL", step.questionnaire);
  }
  void operator()(const ValidationStep& step) const {
    insert("'validation', NULL, ?, NULL, NULL", step.attempts);
  }
  void operator()(const ReactionStep& step) const {
    insert("'reaction', NULL, ?, NULL, NULL", step.presses);
  }
  void operator()(const TrialStep& step) const {
    insert("'trial', NULL, NULL, ?, ?", static_cast<std::int64_t>(step.trial),
           step.chooses_object ? 1 : 0);
  }

 private:
  template <typename... Values>
  void insert(const char* columns, const Values&... values) const {
    SQLite::Statement row(database_,
                          fmt::format("INSERT INTO planned_step VALUES (?, ?, {})", columns));
    SQLite::bind(row, session_, step_, values...);
    row.exec();
  }

  SQLite::Database& database_;
  std::int64_t session_;
  std::int64_t step_;
};

/// trials: how many there are in the plan.
AgendaStep step_from(SQLite::Statement& row, std::int64_t session, std::size_t trials) {
  const std::string kind = row.getColumn("kind").getString();
  if (kind == "consent") {
    return ConsentStep{};
  }
  if (kind == "questionnaire") {
    return QuestionnaireStep{.questionnaire = row.getColumn("questionnaire").getString()};
  }
  if (kind == "validation") {
    return ValidationStep{.attempts = whole_number<std::uint16_t>(row.getColumn("times"))};
  }
  if (kind == "reaction") {
    return ReactionStep{.presses = whole_number<std::uint16_t>(row.getColumn("times"))};
  }
  if (kind == "trial") {
    return TrialStep{.trial = place_in<std::size_t>(row.getColumn("trial"), trials),
                     .chooses_object = row.getColumn("chooses_object").getInt() != 0};
  }
  throw unknown_word(session, kind);
}

Agenda agenda_from_record(SQLite::Database& database, std::int64_t session) {
  Agenda agenda;
  const std::size_t trials = plan_of(database, session).size();
  SQLite::Statement rows(database, "SELECT * FROM planned_step WHERE session = ? ORDER BY step");
  rows.bind(1, session);
  while (rows.executeStep()) {
    agenda.push_back(step_from(rows, session, trials));
  }
  return agenda;
}

std::vector<Question> ratings_from_record(SQLite::Database& database) {
  std::vector<Question> ratings;
  SQLite::Statement rows(database, "SELECT rating, question FROM study_rating ORDER BY position");
  while (rows.executeStep()) {
    ratings.push_back(question_from(rows.getColumn("rating").getString(),
                                    rows.getColumn("question").getString()));
  }
  return ratings;
}

std::vector<ShownScene> scenes_from_record(SQLite::Database& database, std::int64_t session) {
  std::vector<ShownScene> scenes;
  SQLite::Statement rows(database, "SELECT * FROM session_scene WHERE session = ? ORDER BY scene");
  rows.bind(1, session);
  while (rows.executeStep()) {
    scenes.push_back({.name = rows.getColumn("scene").getString(),
                      .file_name = rows.getColumn("file_name").getString(),
                      .sha256 = rows.getColumn("file_sha256").getString(),
                      .shown_as = rows.getColumn("shown_as").getString()});
  }
  return scenes;
}

KnownSession session_from(SQLite::Database& database, SQLite::Statement& row) {
  const std::int64_t id = row.getColumn("id").getInt64();
  return {.id = id,
          .participant = row.getColumn("participant").getString(),
          .kind = session_kind_named(id, row.getColumn("kind").getString()),
          .seed = seed_from(id, row.getColumn("seed").getString()),
          .design_row = whole_number<int>(row.getColumn("design_row")),
          .phase = phase_named(id, row.getColumn("state").getString()),
          .build = build_of(row),
          .devices = row.getColumn("devices").getString(),
          .scenes = scenes_from_record(database, id)};
}

}  // namespace

const char* name_of(SessionKind kind) { return session_kinds.at(static_cast<std::size_t>(kind)); }

std::string random_uuid() {
  std::random_device device;
  std::array<std::uint32_t, 4> words{};
  for (std::uint32_t& word : words) {
    word = device();
  }
  constexpr std::uint32_t version_4 = 0x4000;
  constexpr std::uint32_t variant_1 = 0x8000;
  return fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:04x}{:08x}", words[0], words[1] >> 16U,
                     version_4 | (words[1] & 0x0FFFU), variant_1 | ((words[2] >> 16U) & 0x3FFFU),
                     words[2] & 0xFFFFU, words[3]);
}

std::string uuid_of(const std::string& words) {
  const std::string hash = sha256(std::string_view(words));
  constexpr std::string_view variant_1 = "89ab";
  const char variant = variant_1[static_cast<std::size_t>(hash[16]) % variant_1.size()];
  return fmt::format("{}-{}-8{}-{}{}-{}", hash.substr(0, 8), hash.substr(8, 4), hash.substr(13, 3),
                     variant, hash.substr(17, 3), hash.substr(20, 12));
}

BuildInfo build_of(SQLite::Statement& session) {
  return with_renderer_in(session.getColumn("devices").getString(),
                          {.version = session.getColumn("program_version").getString(),
                           .compiler = session.getColumn("compiler").getString(),
                           .build_type = session.getColumn("build_type").getString()});
}

std::int64_t insert_session(SQLite::Database& database, const SessionFacts& facts,
                            const SessionOrigin& origin, const Plan& plan, const Agenda& agenda) {
  const std::int64_t session = insert_facts(database, facts, origin);
  insert_scenes(database, session, facts.scenes);
  insert_plan(database, session, plan);
  for (std::size_t i = 0; i < agenda.size(); ++i) {
    std::visit(StepRow(database, session, i), agenda[i]);
  }
  return session;
}

bool has_session_of(SQLite::Database& database, const std::string& participant) {
  SQLite::Statement found(database, "SELECT 1 FROM session WHERE participant = ?");
  found.bind(1, participant);
  return found.executeStep();
}

std::vector<KnownSession> sessions_of(SQLite::Database& database) {
  std::vector<KnownSession> sessions;
  SQLite::Statement rows(database, "SELECT * FROM session ORDER BY id");
  while (rows.executeStep()) {
    sessions.push_back(session_from(database, rows));
  }
  return sessions;
}

Plan plan_of(SQLite::Database& database, std::int64_t session) {
  Plan plan;
  SQLite::Statement rows(database, "SELECT * FROM planned_trial WHERE session = ? ORDER BY trial");
  rows.bind(1, session);
  while (rows.executeStep()) {
    plan.push_back({.scene = rows.getColumn("scene").getString(),
                    .method = rows.getColumn("method").getString(),
                    .scene_position = whole_number<int>(rows.getColumn("scene_position")),
                    .method_position = whole_number<int>(rows.getColumn("method_position")),
                    .kind = trial_kind_named(session, rows.getColumn("kind").getString())});
  }
  return plan;
}

Procedure recorded_procedure_of(SQLite::Database& database, std::int64_t session) {
  Procedure procedure;
  procedure.agenda = agenda_from_record(database, session);
  procedure.marks =
      static_cast<std::size_t>(database.execAndGet("SELECT count(*) FROM study_mark").getInt());
  try {
    procedure.ratings = ratings_from_record(database);
  } catch (const std::invalid_argument& fault) {
    throw Error("study_rating", fmt::format("cannot be read ({})", fault.what()), damage_remedy);
  }
  if (procedure.agenda.empty() || procedure.marks == 0) {
    throw Error(fmt::format("session {}", session), "its record has no plan or no marks",
                damage_remedy);
  }
  return procedure;
}

}  // namespace foveola::study
