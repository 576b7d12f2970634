// The files of an open database, read by the handles that SQLite has of them: whoever opened one
// once more would, by closing it, drop the locks that this process has on it
// (https://www.sqlite.org/howtocorrupt.html, section 2.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

struct sqlite3_file;

namespace SQLite {
class Database;
}

namespace foveola::study {

/// A file that SQLite has open, as long as its database is.
class OpenFile {
 public:
  /// Of the database itself.
  static OpenFile database(SQLite::Database& database);
  /// Of its write-ahead log. There is one once something was read or written.
  static OpenFile log(SQLite::Database& database);

  /// In bytes. Throws SQLite::Exception.
  std::uintmax_t size() const;

  /// Whether all of `bytes` could be read from `offset` on.
  bool read(std::uintmax_t offset, std::span<char> bytes) const;

 private:
  explicit OpenFile(sqlite3_file* file) : file_(file) {}

  sqlite3_file* file_;
};

}  // namespace foveola::study
