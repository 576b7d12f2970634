// By what a study can be told from any forgery of it: a head that was written down.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace foveola::study {

/// How far the log of a session went.
struct SessionHead {
  std::string uuid;
  std::int64_t events = 0;
  std::string last_hash;  ///< of the last event, or of what is before the first
};

struct StudyHead {
  std::vector<SessionHead> sessions;  ///< in the order of their UUIDs
  /// Tombstones; uuid is the SHA-256 of the UUID, and they are in the order of that.
  std::vector<SessionHead> forgotten;
  /// The SHA-256 of the sessions' last hashes, and then of those of forgotten ones, joined by line
  /// feeds.
  std::string sha256;
};

/// Throws what SQLite throws.
StudyHead study_head(SQLite::Database& study);

/// Throws Error if the file at `path` is no study.
StudyHead read_head(const std::filesystem::path& path);

/// The sessions and tombstones in a text that holds, on lines of their own, what `study status`
/// prints of them: UUID, number of events, last hash.
std::vector<SessionHead> heads_in(const std::string& text);

/// What is wrong with the tombstones, in words, if anything is.
std::optional<std::string> tombstone_fault(SQLite::Database& study);

/// How a study compares with an earlier head, each in words.
struct HeadComparison {
  std::vector<std::string> faults;     ///< sessions that are not there, or do not continue
  std::vector<std::string> forgotten;  ///< sessions that are forgotten since
};

/// Throws Error if the file at `path` is no study.
HeadComparison compare_with_head(const std::filesystem::path& path,
                                 const std::vector<SessionHead>& earlier);

}  // namespace foveola::study
