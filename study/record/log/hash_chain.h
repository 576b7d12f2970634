// The chain of hashes by which a session's record shows that nothing of it was changed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "study/record/sqlite/prepared_statements.h"

namespace foveola::study {

/// An event as the log holds it.
struct LogLine {
  std::int64_t sequence = 1;
  std::int64_t time_ns = 0;
  std::string utc;
  std::string type;
  std::string payload;
  // Only in schema 5:
  std::optional<std::int64_t> trial;
  std::optional<std::int64_t> attempt;
  std::string measured;  ///< empty for NULL
};

/// What schema.sql describes at event: the hash of the study's and the session's facts and plan,
/// which the first event follows on. Throws what SQLite throws.
std::string hash_before_events(PreparedStatements& statements, std::int64_t session);

/// The line that stands in `row`, whose columns are those of event in a schema.
LogLine log_line(SQLite::Statement& row, int schema);

/// The hash of an event that follows on the one of hash `previous`.
std::string hash_of(const std::string& previous, const LogLine& line, int schema);

}  // namespace foveola::study
