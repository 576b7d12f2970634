// The frames of a recorded attempt, and what its film became, for replaying it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/base/error.h"
#include "study/record/log/chunk.h"
#include "study/record/write/study_store.h"

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace foveola::study {

/// The frames of all chunks of an attempt, in their order. Throws std::invalid_argument if they are
/// not what was written.
std::vector<FrameRow> frames_in(const std::vector<StoredChunk>& chunks);

/// What to throw to the user then.
Error changed_frames(std::int64_t session, std::size_t trial, int attempt);
/// The same of anything else that is kept of an attempt, as "film hashes".
Error changed_record(std::int64_t session, std::size_t trial, int attempt, const char* what);

/// The frames of an attempt in their order; none if it has none. Throws Error if they are not what
/// was written, and what SQLite throws.
std::vector<FrameRow> frames_of(SQLite::Database& database, std::int64_t session, std::size_t trial,
                                int attempt);

/// The hashes of the attempt's film, in the order of frames. Throws Error if they are not what was
/// written, and what SQLite throws.
std::vector<FilmHash> film_hashes_of(SQLite::Database& database, std::int64_t session,
                                     std::size_t trial, int attempt);

/// The checksum that a row of film_hash has, as schema.sql describes it. uuid: of the session;
/// empty in schema 4.
std::string film_row_sha256(const std::string& uuid, std::int64_t trial, int attempt,
                            const FilmHash& hash);

}  // namespace foveola::study
