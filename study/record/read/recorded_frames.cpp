#include "study/record/read/recorded_frames.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "study/record/log/chunk.h"
#include "study/record/log/encodings.h"
#include "study/record/schema.h"
#include "study/record/sqlite/damage_remedy.h"
#include "study/record/sqlite/stored_number.h"

namespace foveola::study {

std::vector<FrameRow> frames_in(const std::vector<StoredChunk>& chunks) {
  std::vector<FrameRow> frames;
  for (const StoredChunk& chunk : chunks) {
    if (chunk.first != std::ssize(frames)) {
      throw std::invalid_argument("a chunk is missing");
    }
    const std::vector<FrameRow> more =
        decode_frames(chunk.encoding, chunk_bytes(chunk, bytes_per_frame(chunk.encoding)));
    frames.insert(frames.end(), more.begin(), more.end());
  }
  return frames;
}

Error changed_frames(std::int64_t session, std::size_t trial, int attempt) {
  return changed_record(session, trial, attempt, "frames");
}

Error changed_record(std::int64_t session, std::size_t trial, int attempt, const char* what) {
  return {fmt::format("session {}, trial {}, attempt {}", session, trial, attempt),
          fmt::format("its {} are not those that were written", what), damage_remedy};
}

std::vector<FrameRow> frames_of(SQLite::Database& database, std::int64_t session, std::size_t trial,
                                int attempt) {
  try {
    return frames_in(ChunkReader(database, "frame_chunk").read(session, trial, attempt));
  } catch (const std::invalid_argument&) {
    throw changed_frames(session, trial, attempt);
  }
}

std::vector<FilmHash> film_hashes_of(SQLite::Database& database, std::int64_t session,
                                     std::size_t trial, int attempt) {
  std::vector<FilmHash> hashes;
  SQLite::Statement rows(
      database,
      fmt::format("SELECT frame, film_sha256, row_sha256, {} FROM film_hash"
                  " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY frame",
                  schema_version_of(database) < 5
                      ? "''"
                      : "(SELECT uuid FROM session WHERE session.id = film_hash.session)"));
  SQLite::bind(rows, session, static_cast<std::int64_t>(trial), attempt);
  while (rows.executeStep()) {
    hashes.push_back({.frame = whole_number<std::uint64_t>(rows.getColumn("frame")),
                      .sha256 = rows.getColumn("film_sha256").getString()});
    if (film_row_sha256(rows.getColumn(3).getString(), static_cast<std::int64_t>(trial), attempt,
                        hashes.back()) != rows.getColumn("row_sha256").getString()) {
      throw changed_record(session, trial, attempt, "film hashes");
    }
  }
  return hashes;
}

std::string film_row_sha256(const std::string& uuid, std::int64_t trial, int attempt,
                            const FilmHash& hash) {
  const std::string session = uuid.empty() ? "" : fmt::format("\"{}\",", uuid);
  return sha256(
      fmt::format("[{}{},{},{},\"{}\"]", session, trial, attempt, hash.frame, hash.sha256));
}

}  // namespace foveola::study
