#include "study/record/recorded_frames.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "study/record/chunk.h"
#include "study/record/frame_encoding.h"
#include "study/record/stored_number.h"

namespace foveola::study {

StoredFrames stored_frames(SQLite::Statement& row) {
  return {row.getColumn("encoding").getString(), row.getColumn("first_frame").getInt64(),
          row.getColumn("frame_count").getInt64(), stored_chunk(row)};
}

std::vector<FrameRow> decode_stored(const std::vector<StoredFrames>& rows) {
  std::vector<FrameRow> frames;
  for (const StoredFrames& row : rows) {
    if (row.first != static_cast<std::int64_t>(frames.size())) {
      throw std::invalid_argument("a chunk is missing");
    }
    const std::vector<FrameRow> more = decode_frames(
        row.encoding, chunk_bytes(row.chunk, row.count, bytes_per_frame(row.encoding)));
    frames.insert(frames.end(), more.begin(), more.end());
  }
  return frames;
}

Error changed_frames(std::int64_t session, std::size_t trial, int attempt) {
  return changed_record(session, trial, attempt, "frames");
}

Error changed_record(std::int64_t session, std::size_t trial, int attempt, const char* what) {
  return {fmt::format("session {}, trial {}, attempt {}", session, trial, attempt),
          fmt::format("its {} are not those that were written", what), "restore it from a copy"};
}

std::vector<FrameRow> frames_of(SQLite::Database& database, std::int64_t session, std::size_t trial,
                                int attempt) {
  std::vector<StoredFrames> rows;
  SQLite::Statement chunks(
      database,
      "SELECT * FROM frame_chunk WHERE session = ? AND trial = ? AND attempt = ?"
      " ORDER BY first_frame");
  SQLite::bind(chunks, session, static_cast<std::int64_t>(trial), attempt);
  while (chunks.executeStep()) {
    rows.push_back(stored_frames(chunks));
  }
  try {
    return decode_stored(rows);
  } catch (const std::invalid_argument&) {
    throw changed_frames(session, trial, attempt);
  }
}

std::vector<FilmHash> film_hashes_of(SQLite::Database& database, std::int64_t session,
                                     std::size_t trial, int attempt) {
  std::vector<FilmHash> hashes;
  SQLite::Statement rows(database,
                         "SELECT frame, film_sha256, row_sha256 FROM film_hash"
                         " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY frame");
  SQLite::bind(rows, session, static_cast<std::int64_t>(trial), attempt);
  while (rows.executeStep()) {
    hashes.push_back({.frame = whole_number<std::uint64_t>(rows.getColumn("frame")),
                      .sha256 = rows.getColumn("film_sha256").getString()});
    if (film_row_sha256(static_cast<std::int64_t>(trial), attempt, hashes.back()) !=
        rows.getColumn("row_sha256").getString()) {
      throw changed_record(session, trial, attempt, "film hashes");
    }
  }
  return hashes;
}

std::string film_row_sha256(std::int64_t trial, int attempt, const FilmHash& hash) {
  return sha256(fmt::format("[{},{},{},\"{}\"]", trial, attempt, hash.frame, hash.sha256));
}

}  // namespace foveola::study
