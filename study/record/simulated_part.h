// The simulated study of which a file holds a part: what shards know of their whole.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace foveola::study {

struct SimulatedWhole {
  std::string seed;  ///< in digits, as sessions have it
  int participants = 0;

  friend bool operator==(const SimulatedWhole&, const SimulatedWhole&) = default;
};

/// The statement that makes the table of it. Only files of parts have the table, and it is not in
/// schema.sql: so all parts, merged, are the file that the whole would have been.
inline constexpr const char* simulated_part_sql =
    "CREATE TABLE simulated_part (seed TEXT NOT NULL, participants INTEGER NOT NULL) STRICT";

/// Empty of a file that is not a part. Throws what SQLite throws.
std::optional<SimulatedWhole> whole_of(SQLite::Database& study);

/// What is wrong with the table, in words, if anything is. Studies of people have none.
std::optional<std::string> part_fault(SQLite::Database& study);

/// Replaces what the file said of its whole.
void mark_as_part(SQLite::Database& study, const SimulatedWhole& whole);

/// The codes of the whole's participants without a session in the file, in their order.
std::vector<std::string> missing_participants(SQLite::Database& study, const SimulatedWhole& whole);

}  // namespace foveola::study
