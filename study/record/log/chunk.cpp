#include "study/record/log/chunk.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <zlib.h>

#include "renderer/base/files/digest.h"
#include "study/record/schema.h"

namespace foveola::study {
namespace {

std::string compressed(const std::string& bytes) {
  std::string data(::compressBound(bytes.size()), '\0');
  uLongf size = data.size();
  const int result = ::compress(reinterpret_cast<Bytef*>(data.data()), &size,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  if (result != Z_OK) {
    throw std::runtime_error(fmt::format("zlib could not compress ({})", result));
  }
  data.resize(size);
  return data;
}

std::invalid_argument changed_chunk() { return std::invalid_argument("is not what was written"); }

/// What is longer or shorter than `size`, or has more behind it, was not written here.
std::string uncompressed(const std::string& data, std::size_t size) {
  std::string bytes(size, '\0');
  uLongf length = size;
  uLong read = data.size();
  const int result = ::uncompress2(reinterpret_cast<Bytef*>(bytes.data()), &length,
                                   reinterpret_cast<const Bytef*>(data.data()), &read);
  if (result != Z_OK || length != size || read != data.size()) {
    throw changed_chunk();
  }
  return bytes;
}

/// The lines before what data holds, as schema.sql describes them.
std::string lines_of_place(const std::string& uuid, std::int64_t trial, std::int64_t attempt,
                           std::int64_t first, std::int64_t count, const std::string& encoding) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", uuid, trial, attempt, first, count, encoding);
}

}  // namespace

void insert_chunk(SQLite::Database& database, const std::string& table, const ChunkPlace& place,
                  const std::string& encoding, const std::string& bytes) {
  const std::string data = compressed(bytes);
  SQLite::Statement row(database,
                        fmt::format("INSERT INTO {} VALUES (?, ?, ?, ?, ?, ?, ?, ?)", table));
  SQLite::bind(row, place.session, place.trial, place.attempt, place.first, place.count, encoding);
  row.bind(7, data.data(), static_cast<int>(data.size()));
  row.bind(8, sha256(lines_of_place(place.uuid, place.trial, place.attempt, place.first,
                                    place.count, encoding) +
                     bytes));
  row.exec();
}

std::string columns_of_chunk(SQLite::Database& study, const std::string& table) {
  const bool is_of_frames = table == "frame_chunk";
  return fmt::format(
      "{0}.trial, {0}.attempt, {0}.{1} AS first, {0}.{2} AS count, {0}.encoding, {0}.data,"
      " {0}.data_sha256, {3} AS uuid",
      table, is_of_frames ? "first_frame" : "first_sample",
      is_of_frames ? "frame_count" : "sample_count",
      schema_version_of(study) < 5
          ? "NULL"
          : fmt::format("(SELECT uuid FROM session WHERE session.id = {}.session)", table));
}

StoredChunk stored_chunk(SQLite::Statement& row) {
  StoredChunk chunk{.first = row.getColumn("first").getInt64(),
                    .count = row.getColumn("count").getInt64(),
                    .encoding = row.getColumn("encoding").getString(),
                    .data = row.getColumn("data").getString(),
                    .place = {},
                    .sha256 = row.getColumn("data_sha256").getString()};
  if (const SQLite::Column uuid = row.getColumn("uuid"); !uuid.isNull()) {
    chunk.place = lines_of_place(uuid.getString(), row.getColumn("trial").getInt64(),
                                 row.getColumn("attempt").getInt64(), chunk.first, chunk.count,
                                 chunk.encoding);
  }
  return chunk;
}

ChunkReader::ChunkReader(SQLite::Database& study, const std::string& table)
    : rows_(study, fmt::format("SELECT {} FROM {} WHERE session = ? AND trial = ? AND attempt = ?"
                               " ORDER BY first",
                               columns_of_chunk(study, table), table)) {}

std::vector<StoredChunk> ChunkReader::read(std::int64_t session, std::size_t trial, int attempt) {
  std::vector<StoredChunk> chunks;
  rows_.reset();
  SQLite::bind(rows_, session, static_cast<std::int64_t>(trial), attempt);
  while (rows_.executeStep()) {
    chunks.push_back(stored_chunk(rows_));
  }
  return chunks;
}

std::string chunk_bytes(const StoredChunk& chunk, std::int64_t bytes_each) {
  constexpr std::int64_t max_zlib_ratio = 1100;
  if (chunk.count < 0 || chunk.count > std::ssize(chunk.data) * max_zlib_ratio / bytes_each) {
    throw changed_chunk();
  }
  std::string bytes = uncompressed(chunk.data, static_cast<std::size_t>(chunk.count * bytes_each));
  if (sha256(chunk.place + bytes) != chunk.sha256) {
    throw changed_chunk();
  }
  return bytes;
}

}  // namespace foveola::study
