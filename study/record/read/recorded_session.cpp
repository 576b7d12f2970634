#include "study/record/read/recorded_session.h"

#include <algorithm>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "study/record/log/event_log.h"
#include "study/record/log/json_member.h"
#include "study/record/read/recorded_frames.h"
#include "study/record/setup/same_protocol.h"
#include "study/record/setup/session_devices.h"
#include "study/record/setup/session_programs.h"
#include "study/record/sqlite/database.h"
#include "study/record/write/session_rows.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

KnownSession session_of(SQLite::Database& database, const fs::path& path,
                        const std::string& participant) {
  const std::vector<KnownSession> sessions = sessions_of(database);
  const auto found =
      std::find_if(sessions.begin(), sessions.end(),
                   [&](const KnownSession& session) { return session.participant == participant; });
  if (found == sessions.end()) {
    throw Error(path.string(), fmt::format("has no session of participant {}", participant),
                "foveola study status says whose sessions there are");
  }
  return *found;
}

std::optional<FieldOfView> view_from(const std::string& devices, const fs::path& path) {
  const std::optional<FieldOfView> view = field_of_view_in(devices);
  if (!view && !member_or_null(parse_json(devices), "display").is_null()) {
    throw Error(path.string(), "does not say what view the session's display showed",
                "compare the file with its backup");
  }
  return view;
}

void read_facts(SQLite::Database& database, const fs::path& path, RecordedSession& session) {
  SQLite::Statement facts(database, "SELECT processor, devices FROM session WHERE id = ?");
  facts.bind(1, session.known.id);
  facts.executeStep();
  session.processor = facts.getColumn(0).getString();
  session.view = view_from(facts.getColumn(1).getString(), path);
  session.simulation = simulation_kind_in(facts.getColumn(1).getString());
}

std::vector<RecordedAttempt> attempts_in(const std::string& whose, const Procedure& procedure,
                                         const std::vector<LoggedEvent>& events) {
  std::vector<RecordedAttempt> attempts;
  for_each_step(
      procedure, events, whose,
      [&](const LoggedEvent& logged, const SessionState& /*before*/, const SessionState& after) {
        if (std::holds_alternative<TrialStarted>(logged.event)) {
          attempts.push_back({.trial = *trial_of(procedure, after),
                              .attempt = after.attempt,
                              .timing = after.timing});
        }
      });
  return attempts;
}

}  // namespace

RecordedSession read_session(const fs::path& path, const std::string& participant) {
  RecordedSession session;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    session.known = session_of(database, path, participant);
    read_facts(database, path, session);
    session.plan = plan_of(database, session.known.id);
    session.procedure = recorded_procedure_of(database, session.known.id);
    session.events = events_of(database, session.known.id);
    session.programs = programs_of(session.known, session.events);
    session.attempts = attempts_in(path.string(), session.procedure, session.events);
  });
  return session;
}

RecordedFrames read_frames(const fs::path& path, const KnownSession& session,
                           const RecordedAttempt& attempt) {
  RecordedFrames recorded;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    recorded.frames = frames_of(database, session.id, attempt.trial, attempt.attempt);
    recorded.hashes = film_hashes_of(database, session.id, attempt.trial, attempt.attempt);
  });
  return recorded;
}

Protocol read_recorded_protocol(const fs::path& path, const fs::path& folder) {
  Protocol protocol;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    SQLite::Statement study(database, "SELECT protocol_name, protocol_text FROM study");
    study.executeStep();
    protocol = read_protocol(study.getColumn(1).getString(),
                             folder / (study.getColumn(0).getString() + ".toml"));
    require_same_protocol(database, path, protocol);
  });
  return protocol;
}

}  // namespace foveola::study
