// The chain of hashes by which a session's record shows that nothing of it was changed.
#pragma once

#include <cstdint>
#include <string>

#include "study/record/prepared_statements.h"

namespace foveola::study {

/// An event as the log holds it.
struct LogLine {
  std::int64_t sequence = 1;
  std::int64_t time_ns = 0;
  std::string utc;
  std::string type;
  std::string payload;
};

/// What schema.sql describes at event: the hash of the study's and the session's facts and plan,
/// which the first event follows on. Throws what SQLite throws.
std::string hash_before_events(PreparedStatements& statements, std::int64_t session);

/// The hash of an event that follows on the one of hash `previous`.
std::string hash_of(const std::string& previous, const LogLine& line);

}  // namespace foveola::study
