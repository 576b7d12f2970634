// What is kept of an attempt in large numbers, compressed and with a checksum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <SQLiteCpp/Statement.h>

namespace foveola::study {

/// Where a chunk belongs.
struct ChunkPlace {
  std::int64_t session = 0;
  std::string uuid;  ///< the session's
  std::int64_t trial = 0;
  int attempt = 1;
  std::int64_t first = 0;  ///< frame or sample, counted from the attempt's start
  std::int64_t count = 0;  ///< how many frames or samples it holds
};

/// Appends a row to `table`, frame_chunk or gaze_chunk. bytes: encoded, not yet compressed. Call it
/// inside a transaction. Throws what SQLite throws.
void insert_chunk(SQLite::Database& database, const std::string& table, const ChunkPlace& place,
                  const std::string& encoding, const std::string& bytes);

/// A row of a table of chunks, all but its session.
struct StoredChunk {
  std::int64_t first = 0;
  std::int64_t count = 0;
  std::string encoding;
  std::string data;
  std::string place;  ///< the lines that its hash covers before what data holds
  std::string sha256;
};

/// The columns that stored_chunk() reads, in SQL, of frame_chunk or gaze_chunk in this study.
std::string columns_of_chunk(SQLite::Database& study, const std::string& table);

/// The row that stands in `row`.
StoredChunk stored_chunk(SQLite::Statement& row);

/// Reads the chunks of attempts by a statement that is prepared once.
class ChunkReader {
 public:
  /// table: frame_chunk or gaze_chunk of `study`, which must outlive this. Throws what SQLite
  /// throws, as read() does.
  ChunkReader(SQLite::Database& study, const std::string& table);

  /// An attempt's chunks in their order.
  std::vector<StoredChunk> read(std::int64_t session, std::size_t trial, int attempt);

 private:
  SQLite::Statement rows_;
};

/// The chunk uncompressed, which has to be its count times `bytes_each`. Throws
/// std::invalid_argument if it is not what was written.
std::string chunk_bytes(const StoredChunk& chunk, std::int64_t bytes_each);

}  // namespace foveola::study
