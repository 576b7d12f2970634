// The frames of a recorded attempt, and what its film became, for replaying it.
#pragma once

#include <cstdint>
#include <vector>

#include "study/record/study_store.h"

namespace SQLite {
class Database;
}

namespace foveola::study {

/// The frames of an attempt in their order; none if it has none. Throws Error if they are not what
/// was written, and what SQLite throws.
std::vector<FrameRow> frames_of(SQLite::Database& database, std::int64_t session, std::size_t trial,
                                int attempt);

/// What is known of the attempt's film, in the order of frames. Throws likewise.
std::vector<FilmHash> film_hashes_of(SQLite::Database& database, std::int64_t session,
                                     std::size_t trial, int attempt);

/// The checksum that a row of film_hash has, as schema.sql describes it.
std::string film_row_sha256(std::int64_t trial, int attempt, const FilmHash& hash);

}  // namespace foveola::study
