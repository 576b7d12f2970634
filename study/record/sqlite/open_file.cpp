#include "study/record/sqlite/open_file.h"

#include <algorithm>

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

namespace foveola::study {
namespace {

sqlite3_file* file_of(SQLite::Database& database, int which) {
  sqlite3_file* file = nullptr;
  ::sqlite3_file_control(database.getHandle(), "main", which, static_cast<void*>(&file));
  if (file == nullptr || file->pMethods == nullptr) {
    throw SQLite::Exception("the file is not open", SQLITE_CANTOPEN);
  }
  return file;
}

}  // namespace

OpenFile OpenFile::database(SQLite::Database& database) {
  return OpenFile(file_of(database, SQLITE_FCNTL_FILE_POINTER));
}

OpenFile OpenFile::log(SQLite::Database& database) {
  return OpenFile(file_of(database, SQLITE_FCNTL_JOURNAL_POINTER));
}

std::uintmax_t OpenFile::size() const {
  sqlite3_int64 size = 0;
  if (file_->pMethods->xFileSize(file_, &size) != SQLITE_OK) {
    throw SQLite::Exception("the file has no size", SQLITE_IOERR);
  }
  return static_cast<std::uintmax_t>(size);
}

bool OpenFile::read(std::uintmax_t offset, std::span<char> bytes) const {
  constexpr std::size_t max_read_bytes = std::size_t{1} << 20;  // SQLite counts in int
  while (!bytes.empty()) {
    const std::span<char> part = bytes.first(std::min(bytes.size(), max_read_bytes));
    if (file_->pMethods->xRead(file_, part.data(), static_cast<int>(part.size()),
                               static_cast<sqlite3_int64>(offset)) != SQLITE_OK) {
      return false;
    }
    offset += part.size();
    bytes = bytes.subspan(part.size());
  }
  return true;
}

}  // namespace foveola::study
