#include "study/record/chunk.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <zlib.h>

#include "renderer/base/digest.h"

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

/// What is longer or shorter than `size` was not written here.
std::string uncompressed(const std::string& data, std::size_t size) {
  std::string bytes(size, '\0');
  uLongf length = size;
  const int result = ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                                  reinterpret_cast<const Bytef*>(data.data()), data.size());
  if (result != Z_OK || length != size) {
    throw changed_chunk();
  }
  return bytes;
}

}  // namespace

void insert_chunk(SQLite::Database& database, const std::string& table, const ChunkPlace& place,
                  const std::string& encoding, const std::string& bytes) {
  const std::string data = compressed(bytes);
  SQLite::Statement row(database,
                        fmt::format("INSERT INTO {} VALUES (?, ?, ?, ?, ?, ?, ?, ?)", table));
  SQLite::bind(row, place.session, place.trial, place.attempt, place.first, place.count, encoding);
  row.bind(7, data.data(), static_cast<int>(data.size()));
  row.bind(8, sha256(bytes));
  row.exec();
}

StoredChunk stored_chunk(SQLite::Statement& row) {
  return {row.getColumn("data").getString(), row.getColumn("data_sha256").getString()};
}

std::string chunk_bytes(const StoredChunk& chunk, std::int64_t count, std::int64_t bytes_each) {
  constexpr std::int64_t max_zlib_ratio = 1100;
  if (count < 0 || count > std::ssize(chunk.data) * max_zlib_ratio / bytes_each) {
    throw changed_chunk();
  }
  std::string bytes = uncompressed(chunk.data, static_cast<std::size_t>(count * bytes_each));
  if (sha256(bytes) != chunk.sha256) {
    throw changed_chunk();
  }
  return bytes;
}

}  // namespace foveola::study
