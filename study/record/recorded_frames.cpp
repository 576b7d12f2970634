#include "study/record/recorded_frames.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "study/record/chunk.h"
#include "study/record/frame_encoding.h"

namespace foveola::study {
namespace {

Error changed_record(std::int64_t session, std::size_t trial, int attempt, const char* what) {
  return {fmt::format("session {}, trial {}, attempt {}", session, trial, attempt),
          fmt::format("its {} are not those that were written", what), "restore it from a copy"};
}

}  // namespace

std::vector<FrameRow> frames_of(SQLite::Database& database, std::int64_t session, std::size_t trial,
                                int attempt) {
  std::vector<FrameRow> frames;
  SQLite::Statement chunks(
      database,
      "SELECT encoding, data, data_sha256, first_frame, frame_count FROM frame_chunk"
      " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY first_frame");
  SQLite::bind(chunks, session, static_cast<std::int64_t>(trial), attempt);
  while (chunks.executeStep()) {
    try {
      const std::string encoding = chunks.getColumn("encoding").getString();
      const std::int64_t count = chunks.getColumn("frame_count").getInt64();
      const std::vector<FrameRow> more =
          decode_frames(encoding, chunk_bytes(chunks, count * bytes_per_frame(encoding)));
      if (chunks.getColumn("first_frame").getInt64() != static_cast<std::int64_t>(frames.size())) {
        throw std::invalid_argument("a chunk is missing");
      }
      frames.insert(frames.end(), more.begin(), more.end());
    } catch (const std::invalid_argument&) {
      throw changed_record(session, trial, attempt, "frames");
    }
  }
  return frames;
}

std::vector<FilmHash> film_hashes_of(SQLite::Database& database, std::int64_t session,
                                     std::size_t trial, int attempt) {
  std::vector<FilmHash> hashes;
  SQLite::Statement rows(database,
                         "SELECT frame, film_sha256, row_sha256 FROM film_hash"
                         " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY frame");
  SQLite::bind(rows, session, static_cast<std::int64_t>(trial), attempt);
  while (rows.executeStep()) {
    hashes.push_back({.frame = static_cast<std::uint64_t>(rows.getColumn("frame").getInt64()),
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
