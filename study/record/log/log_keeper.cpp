#include "study/record/log/log_keeper.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "study/record/log/big_endian.h"
#include "study/record/sqlite/database_checks.h"
#include "study/record/sqlite/open_file.h"
#include "study/record/sqlite/temporary_database.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

// https://www.sqlite.org/fileformat2.html, section 4.1: a log is a header and frames, each of a
// header and a page. Whoever begins the log anew draws other salts.
constexpr std::size_t log_header_size = 32;
constexpr std::size_t frame_header_size = 24;
constexpr std::string_view log_magic("\x37\x7f\x06", 3);
constexpr int checkpoint_pages = 1000;  // SQLite's own default

std::string_view salts_of(std::string_view log) { return log.substr(16, 8); }

std::size_t frame_size_in(std::string_view log) { return frame_header_size + big_endian(log, 8); }

/// A file that SQLite does not lock, read by its name.
class NamedFile {
 public:
  explicit NamedFile(const fs::path& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK)) {}
  ~NamedFile() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
  }
  NamedFile(const NamedFile&) = delete;
  NamedFile& operator=(const NamedFile&) = delete;

  bool has(std::string_view bytes, std::size_t offset) const {
    std::string found(bytes.size(), '\0');
    return ::pread(descriptor_, found.data(), found.size(), static_cast<off_t>(offset)) ==
               static_cast<ssize_t>(found.size()) &&
           found == bytes;
  }

 private:
  int descriptor_;
};

void write_bytes(const fs::path& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) {
    throw Error(path.string(), "cannot be written", "check the free space");
  }
}

void copy_bytes(const OpenFile& from, const fs::path& to) {
  std::string bytes(from.size(), '\0');
  if (!from.read(0, bytes)) {
    throw Error(to.string(), "cannot be made: the study cannot be read", "check the disk");
  }
  write_bytes(to, bytes);
}

}  // namespace

LogKeeper::LogKeeper(SQLite::Database& database)
    : database_(database),
      log_(std::string(::sqlite3_db_filename(database.getHandle(), "main")) + "-wal") {
  ::sqlite3_wal_hook(database.getHandle(), note_pages, this);
  database.execAndGet("PRAGMA schema_version");  // opens the log
  make_checkpoint();
  keep_new_frames();
}

LogKeeper::~LogKeeper() { ::sqlite3_wal_hook(database_.getHandle(), nullptr, nullptr); }

int LogKeeper::note_pages(void* keeper, sqlite3* /*database*/, const char* /*name*/, int pages) {
  static_cast<LogKeeper*>(keeper)->pages_ = pages;
  return SQLITE_OK;
}

void LogKeeper::make_checkpoint() {
  int pages = 0;
  const int result = ::sqlite3_wal_checkpoint_v2(database_.getHandle(), "main",
                                                 SQLITE_CHECKPOINT_PASSIVE, &pages, nullptr);
  // Whoever reads the log may hold it up. The next one does what is left.
  if (result != SQLITE_OK && result != SQLITE_BUSY && result != SQLITE_LOCKED) {
    throw SQLite::Exception(database_.getHandle(), result);
  }
  pages_ = std::max(pages, 0);
}

/// Whether the log that SQLite has open holds what it held, and what was committed since.
bool LogKeeper::keep_new_frames() {
  if (pages_ == 0) {
    kept_.clear();
    return true;
  }
  const OpenFile log = OpenFile::log(database_);
  std::string header(log_header_size, '\0');
  if (!log.read(0, header) || !header.starts_with(log_magic)) {
    return false;
  }
  const std::size_t frame_size = frame_size_in(header);
  if (kept_.empty() || salts_of(header) != salts_of(kept_)) {
    kept_ = header;
  } else if (kept_.size() > log_header_size) {
    // Of a log that was cut off, SQLite goes on where it was, with zeros before.
    std::string last(frame_size, '\0');
    if (!log.read(kept_.size() - frame_size, last) || !kept_.ends_with(last)) {
      return false;
    }
  }
  const std::size_t end = log_header_size + static_cast<std::size_t>(pages_) * frame_size;
  if (end <= kept_.size()) {
    return end == kept_.size();
  }
  const std::size_t known = kept_.size();
  kept_.resize(end);
  return log.read(known, std::span(kept_).subspan(known));
}

bool LogKeeper::is_under_its_name() const {
  if (kept_.empty()) {
    return true;
  }
  const NamedFile log(log_);
  const std::size_t frame = kept_.size() - frame_size_in(kept_);
  return log.has(std::string_view(kept_).substr(0, log_header_size), 0) &&
         log.has(std::string_view(kept_).substr(frame), frame);
}

bool LogKeeper::holds_last_commit() {
  if (!keep_new_frames() || !is_under_its_name()) {
    return false;
  }
  if (pages_ >= checkpoint_pages) {
    make_checkpoint();
  }
  return true;
}

void LogKeeper::save(const fs::path& path) {
  // What closes last would fold the log into the study's file, and remove what has its name now.
  ::sqlite3_db_config(database_.getHandle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  const TemporaryDatabase temporary(path);
  copy_bytes(OpenFile::database(database_), temporary.path());
  write_bytes(temporary.path().string() + "-wal", kept_);
  {
    SQLite::Database copy(temporary.path(), SQLite::OPEN_READWRITE);
    copy.execAndGet("PRAGMA journal_mode = DELETE");
    require_intact(copy, path);
  }
  temporary.take_free_name();
}

bool has_commits_in_log(SQLite::Database& database) {
  if (database.execAndGet("PRAGMA journal_mode").getString() != "wal") {
    return false;  // SQLite reads no log
  }
  const OpenFile log = OpenFile::log(database);
  std::string bytes(log.size(), '\0');
  if (bytes.size() < log_header_size || !log.read(0, bytes)) {
    return false;
  }
  using Pages = std::map<std::uintmax_t, std::string_view>;  // by their numbers, which begin with 1
  Pages committed;
  Pages transaction;
  const std::size_t frame_size = frame_size_in(bytes);
  for (std::size_t at = log_header_size; at + frame_size <= bytes.size(); at += frame_size) {
    const std::string_view frame = std::string_view(bytes).substr(at, frame_size);
    if (frame.substr(8, 8) != salts_of(bytes)) {
      break;  // from before the log was begun anew
    }
    transaction[big_endian(frame, 0)] = frame.substr(frame_header_size);
    const std::uintmax_t pages_after_commit = big_endian(frame, 4);
    if (pages_after_commit != 0) {
      transaction.merge(committed);
      committed = std::exchange(transaction, {});
    }
  }
  const OpenFile file = OpenFile::database(database);
  return std::ranges::any_of(committed, [&](const Pages::value_type& page) {
    std::string in_file(page.second.size(), '\0');
    return !file.read((page.first - 1) * in_file.size(), in_file) || in_file != page.second;
  });
}

}  // namespace foveola::study
