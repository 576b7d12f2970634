#include "study/record/sqlite/database.h"

#include <system_error>

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "study/record/log/question_json.h"
#include "study/record/schema.h"
#include "study/record/sqlite/controller_lock.h"
#include "study/record/sqlite/damage_remedy.h"
#include "study/record/sqlite/database_checks.h"
#include "study/record/sqlite/journal_check.h"
#include "study/record/sqlite/temporary_database.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

constexpr int busy_timeout_ms = 5000;
/// A session's record waits longer for another program's lock: an error would end the session.
constexpr int writer_timeout_ms = 60'000;

Error error_of(const fs::path& path, const SQLite::Exception& fault) {
  const auto error = [&](const std::string& what, const std::string& remedy) {
    return Error(path.string(), what, remedy);
  };
  switch (fault.getErrorCode()) {
    case SQLITE_FULL:
      return error("the disk is full", "free some space; what was acknowledged is safe");
    case SQLITE_READONLY:
      return error("cannot be written", "check its permissions and its folder's");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return error("is in use by another program", "close it, then repeat the command");
    case SQLITE_NOTADB:
      return error("is no database", "name a study that foveola has written, or a new file");
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // The schema is known, so that only a value can make a statement fail.
      return error(fmt::format("is damaged ({})", fault.what()), damage_remedy);
    case SQLITE_CANTOPEN:
      return error("cannot be opened", "check its permissions and its folder's");
    case SQLITE_IOERR:
      return error(fmt::format("cannot be read or written ({})", fault.what()),
                   "check the disk and its free space; what was acknowledged is safe");
    default:
      return error(fault.what(), "");
  }
}

/// The file as a URI by which SQLite reads it without locks or side files.
std::string immutable_uri(const fs::path& path) {
  std::string uri = "file:";
  for (const char c : fs::absolute(path).string()) {
    const bool is_plain = c != '%' && c != '?' && c != '#';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri + "?immutable=1";
}

SQLite::Database open_immutable(const fs::path& path) {
  return {immutable_uri(path), SQLite::OPEN_READONLY | SQLite::OPEN_URI};
}

/// Of a copy that has no name any more when this returns: where the folder cannot be written,
/// SQLite cannot read a log; where a journal is beside it, SQLite would have to play it back first.
SQLite::Database open_copy(const fs::path& path) {
  const ScratchFolder folder;
  const fs::path copy = folder / path.filename().string();
  for (const char* suffix : {"", "-wal"}) {
    fs::copy_file(path.string() + suffix, copy.string() + suffix);
  }
  SQLite::Database database(copy, SQLite::OPEN_READWRITE);
  database.execAndGet("PRAGMA schema_version");
  return database;
}

/// A file with a log beside it.
SQLite::Database open_with_log(const fs::path& path) {
  // Looking at the file itself would end the lock of a session in this process.
  if (has_playable_journal(path) && !is_controlled(path)) {
    require_own_journal(path);
    return open_copy(path);
  }
  try {
    SQLite::Database database(path, SQLite::OPEN_READONLY, busy_timeout_ms);
    database.execAndGet("PRAGMA schema_version");
    return database;
  } catch (const SQLite::Exception& fault) {
    const bool is_folder_written_by_nobody =
        (fault.getErrorCode() == SQLITE_CANTOPEN || fault.getErrorCode() == SQLITE_READONLY) &&
        ::eaccess(folder_of(path).c_str(), W_OK) != 0;
    if (!is_folder_written_by_nobody) {
      throw;
    }
    return open_copy(path);
  }
}

/// A file with two names could be written by two programs at once, each with a lock and a log
/// beside its own name, and whoever reads by one name misses what is in the log beside the other.
void require_single_name(const fs::path& path) {
  std::error_code ignored;
  if (const std::uintmax_t names = fs::hard_link_count(path, ignored); !ignored && names > 1) {
    throw Error(path.string(),
                fmt::format("has {} names (hard links), by which two programs could write it at "
                            "once",
                            names),
                "remove all but the one that is in use (find -samefile lists them), or go on with "
                "a copy of it (cp)");
  }
}

void require_regular_file(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) {
    throw Error(path.string(), "no such file", "check the path");
  }
  if (!fs::is_regular_file(status)) {
    throw Error(path.string(), "is not a regular file", "name a study that foveola has written");
  }
  require_single_name(path);
}

void insert_study(SQLite::Database& database, const Protocol& protocol,
                  const std::string& created_utc) {
  SQLite::Statement study(database, "INSERT INTO study VALUES (1, ?, ?, ?, ?, ?)");
  SQLite::bind(study, protocol.name, protocol.title, protocol.text, protocol.sha256, created_utc);
  study.exec();
  for (std::size_t i = 0; i < protocol.scenes.size(); ++i) {
    SQLite::Statement scene(database, "INSERT INTO study_scene VALUES (?, ?)");
    SQLite::bind(scene, static_cast<std::int64_t>(i), protocol.scenes[i].name);
    scene.exec();
  }
  for (std::size_t i = 0; i < protocol.methods.size(); ++i) {
    SQLite::Statement method(database, "INSERT INTO study_method VALUES (?, ?)");
    SQLite::bind(method, static_cast<std::int64_t>(i), protocol.methods[i]);
    method.exec();
  }
  for (const MethodFile& file : protocol.method_files) {
    SQLite::Statement row(database, "INSERT INTO study_method_file VALUES (?, ?, ?)");
    SQLite::bind(row, file.method, file.file, file.sha256);
    row.exec();
  }
  for (const NamedProfile& profile : named_profiles(protocol)) {
    SQLite::Statement row(database, "INSERT INTO study_profile VALUES (?, ?, ?, ?)");
    SQLite::bind(row, profile.device, profile.name, profile.toml, sha256(profile.toml));
    row.exec();
  }
  for (std::size_t i = 0; i < protocol.marks.size(); ++i) {
    SQLite::Statement mark(database, "INSERT INTO study_mark VALUES (?, ?)");
    SQLite::bind(mark, static_cast<std::int64_t>(i), protocol.marks[i].id);
    mark.exec();
  }
  for (std::size_t i = 0; i < protocol.ratings.size(); ++i) {
    SQLite::Statement rating(database, "INSERT INTO study_rating VALUES (?, ?, ?)");
    SQLite::bind(rating, static_cast<std::int64_t>(i), protocol.ratings[i].id,
                 question_json(protocol.ratings[i]));
    rating.exec();
  }
}

void write_new_study(const fs::path& path, const Protocol& protocol,
                     const std::string& created_utc) {
  SQLite::Database database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
  SQLite::Transaction transaction(database);
  database.exec(study_schema());
  insert_study(database, protocol, created_utc);
  transaction.commit();
  database.exec("PRAGMA journal_mode = WAL");
}

}  // namespace

void keep_no_memory_counts() { ::sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0); }

void with_clear_errors(const fs::path& path, const std::function<void()>& work) {
  try {
    work();
  } catch (const SQLite::Exception& fault) {
    throw error_of(path, fault);
  }
}

void with_named_target(const fs::path& target, const std::function<void()>& work) {
  try {
    work();
  } catch (const SQLite::Exception& fault) {
    if (fault.getErrorCode() == SQLITE_FULL) {
      throw error_of(target, fault);
    }
    throw;
  }
}

void require_study(const fs::path& path) {
  require_regular_file(path);
  SQLite::Database database = open_as_it_is(path);
  const int application_id = database.execAndGet("PRAGMA application_id").getInt();
  const int version = database.execAndGet("PRAGMA user_version").getInt();
  if (application_id != study_application_id) {
    throw Error(path.string(), "is no study of Foveola",
                "name a study that foveola has written, or a new file");
  }
  if (version < oldest_schema_version || version > study_schema_version) {
    throw Error(path.string(),
                fmt::format("has schema {}, and this program knows only {} and {}", version,
                            oldest_schema_version, study_schema_version),
                version > study_schema_version ? "use a newer Foveola"
                : version > 0 ? "go on with the Foveola that began it, or begin a new study"
                              : damage_remedy);
  }
}

bool has_log(const fs::path& path) { return fs::exists(path.string() + "-wal"); }

SQLite::Database open_as_it_is(const fs::path& path) {
  const fs::path file = fs::canonical(path);
  // Without a log nobody writes, and SQLite would leave an empty one behind if it took part.
  return has_log(file) ? open_with_log(file) : open_immutable(file);
}

SQLite::Database open_study_to_read(const fs::path& path) {
  require_study(path);
  SQLite::Database database = open_as_it_is(path);
  require_whole_pages(database, path);
  require_sound(database, path);
  require_schema(database, path);
  return database;
}

void create_study(const fs::path& path, const Protocol& protocol, const std::string& created_utc) {
  const TemporaryDatabase temporary(path);
  write_new_study(temporary.path(), protocol, created_utc);
  temporary.take_free_name();
}

void fold_in_log(const fs::path& path) {
  if (!has_log(path) && !has_journal(path)) {
    return;
  }
  require_own_journal(path);
  SQLite::Database database(path, SQLite::OPEN_READWRITE, busy_timeout_ms);
  database.execAndGet("PRAGMA journal_mode = DELETE");
  if (has_log(path)) {
    throw Error(path.string(), "is in use by another program", "close it, then repeat the command");
  }
}

void end_log(SQLite::Database& database) {
  constexpr int moment_ms = 1000;
  database.setBusyTimeout(moment_ms);
  database.tryExec("PRAGMA wal_checkpoint(TRUNCATE)");
  database.tryExec("PRAGMA journal_mode = DELETE");
}

void copy_checked(SQLite::Database& database, const fs::path& path) {
  const TemporaryDatabase temporary(path);
  copy_into(temporary, database, path);
  temporary.replace_final();
}

void copy_into(const TemporaryDatabase& temporary, SQLite::Database& database,
               const fs::path& path) {
  with_named_target(path, [&] {
    SQLite::Database copy(temporary.path(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    SQLite::Backup(copy, database).executeStep();
    // So that reading it makes no files beside it.
    copy.execAndGet("PRAGMA journal_mode = DELETE");
  });
  SQLite::Database copy = open_immutable(temporary.path());
  require_intact(copy, path);
}

void require_writable_file(const fs::path& path) {
  if (::access(path.c_str(), W_OK) != 0) {
    throw Error(path.string(), "cannot be written", "check its permissions");
  }
}

SQLite::Database open_study_to_write(const fs::path& path) {
  require_writable_file(path);
  require_own_journal(path);
  SQLite::Database database(path, SQLite::OPEN_READWRITE, busy_timeout_ms);
  // What is removed leaves zeros: see unused_bytes_fault().
  database.exec("PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL; PRAGMA secure_delete = ON");
  const std::string mode = database.execAndGet("PRAGMA journal_mode = WAL").getString();
  if (mode != "wal") {
    throw Error(path.string(), "its folder does not support a write-ahead log",
                "keep studies on a local disk");
  }
  database.setBusyTimeout(writer_timeout_ms);
  return database;
}

}  // namespace foveola::study
