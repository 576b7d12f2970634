// Records in a shard's file which simulated study it is part of. All functions throw
// SQLite::Exception if the database cannot be read or written.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace foveola::study {

struct ShardedStudy {
  std::string seed;      ///< in digits, as sessions have it
  int participants = 0;  ///< of all shards

  friend bool operator==(const ShardedStudy&, const ShardedStudy&) = default;
};

/// SQL that creates the table. It is not in schema.sql, and only shards have it. Merging all shards
/// therefore gives the same file as simulating at once.
inline constexpr const char* simulated_part_sql =
    "CREATE TABLE simulated_part (seed TEXT NOT NULL, participants INTEGER NOT NULL) STRICT";

/// Returns the study that the file is part of. Empty if the file is not a shard.
std::optional<ShardedStudy> read_sharded_study(SQLite::Database& study);

/// Returns a description of an invalid table; empty if it is valid or absent.
std::optional<std::string> part_fault(SQLite::Database& study);

/// Marks the file as a shard of `whole`. Replaces an earlier entry.
void mark_as_part(SQLite::Database& study, const ShardedStudy& whole);

/// Returns the codes of the participants of `whole` without a session in the file, in their order.
std::vector<std::string> missing_participants(SQLite::Database& study, const ShardedStudy& whole);

}  // namespace foveola::study
