// Whether a study's write-ahead log is still the one that SQLite writes, and a copy of it in case
// it is not. Tools that synchronise or clean folders remove and replace it, of which SQLite takes
// no notice: what it then writes is in no file that anybody can open.
#pragma once

#include <filesystem>
#include <string>

#include <sqlite3.h>

namespace SQLite {
class Database;
}

namespace foveola::study {

/// Keeps what is in the log of a database: a few megabytes, for SQLite begins it anew every
/// thousand pages. SQLite's own checkpoints are made here.
class LogKeeper {
 public:
  /// database: open to write, in WAL mode; must outlive this. Throws what SQLite throws.
  explicit LogKeeper(SQLite::Database& database);
  ~LogKeeper();
  LogKeeper(const LogKeeper&) = delete;
  LogKeeper& operator=(const LogKeeper&) = delete;

  /// To be called after each commit: whether whoever opens the file now finds what was committed.
  bool holds_last_commit();

  /// Makes a study at `path`, where there must be none, of all that was committed, whatever became
  /// of the log. Nothing more must be committed after it. Throws Error or what SQLite throws.
  void save(const std::filesystem::path& path);

 private:
  static int note_pages(void* keeper, sqlite3* database, const char* name, int pages);
  bool keep_new_frames();
  bool is_under_its_name() const;
  void make_checkpoint();

  SQLite::Database& database_;
  std::filesystem::path log_;
  int pages_ = 0;     ///< in the log, as SQLite said of the last commit
  std::string kept_;  ///< the log's bytes
};

/// Whether the log beside a database, which is open and was read, holds commits that are not in its
/// file yet.
bool has_commits_in_log(SQLite::Database& database);

}  // namespace foveola::study
