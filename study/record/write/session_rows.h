// A session's facts and plan as rows of the record, and back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/record/write/study_store.h"

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace foveola::study {

/// The name that records use: "human", "pilot", "simulated".
const char* name_of(SessionKind kind);

/// Where a session comes from.
struct SessionOrigin {
  std::string uuid;
  std::string started_utc;
};

/// A random UUID (RFC 4122, section 4.4), so that the records of several sites can be merged.
std::string random_uuid();

/// The UUID of what these words describe (RFC 9562, section 5.8: by their SHA-256).
std::string uuid_of(const std::string& words);

/// Writes a session in which nothing has happened yet. Returns its row id. Call it inside a
/// transaction. Throws what SQLite throws.
std::int64_t insert_session(SQLite::Database& database, const SessionFacts& facts,
                            const SessionOrigin& origin, const Plan& plan, const Agenda& agenda);

/// The program that began the session at which `session`, a row of its table with all columns,
/// stands.
BuildInfo build_of(SQLite::Statement& session);

bool has_session_of(SQLite::Database& database, const std::string& participant);

/// All sessions in the order in which they were begun.
std::vector<KnownSession> sessions_of(SQLite::Database& database);

/// The session's plan as it was recorded before anything happened.
Plan plan_of(SQLite::Database& database, std::int64_t session);

/// What the machine needs to go through the session's events again. Throws Error if the record does
/// not say.
Procedure recorded_procedure_of(SQLite::Database& database, std::int64_t session);

}  // namespace foveola::study
