#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "study/record/controller_lock.h"
#include "study/record/database.h"
#include "study/record/database_checks.h"
#include "study/record/maintenance.h"
#include "study/record/schema.h"
#include "study/record/table_rows.h"
#include "study/record/temporary_database.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

struct FoundSession {
  std::int64_t id = 0;
  std::string uuid;
};

std::optional<FoundSession> session_of(SQLite::Database& study, const std::string& code) {
  SQLite::Statement found(study, "SELECT id, uuid FROM session WHERE participant = ?");
  found.bind(1, code);
  if (!found.executeStep()) {
    return std::nullopt;
  }
  return FoundSession{.id = found.getColumn(0).getInt64(), .uuid = found.getColumn(1).getString()};
}

bool has_column_session(SQLite::Database& study, const std::string& table) {
  SQLite::Statement found(study, "SELECT 1 FROM pragma_table_info(?) WHERE name = 'session'");
  found.bind(1, table);
  return found.executeStep();
}

/// The rows that stay.
std::string others_than(SQLite::Database& study, const std::string& table, std::int64_t session) {
  if (table == "session") {
    return fmt::format("id <> {}", session);
  }
  return has_column_session(study, table) ? fmt::format("session <> {}", session) : "true";
}

/// SQLite's own tables are made with the others.
SQLite::Statement objects_of(SQLite::Database& study, const char* types) {
  return {study, fmt::format("SELECT name, sql FROM sqlite_schema WHERE type IN ({})"
                             " AND sql IS NOT NULL AND name NOT LIKE 'sqlite!_%' ESCAPE '!'"
                             " ORDER BY rowid",
                             types)};
}

/// Makes what a CREATE of the file says; what a stranger may have put behind it is not run.
void make(SQLite::Database& target, const std::string& sql) {
  SQLite::Statement(target, sql).exec();
}

/// Makes a new file of the rows that stay: one from which rows were removed keeps their bytes in
/// its free space. secure_delete fills that of the new one with zeros, whatever was in the memory.
void copy_others(SQLite::Database& study, std::int64_t session, const fs::path& path) {
  SQLite::Database target(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  target.exec("PRAGMA secure_delete = ON");
  SQLite::Transaction transaction(target);
  SQLite::Statement tables = objects_of(study, "'table'");
  while (tables.executeStep()) {
    const std::string table = tables.getColumn("name").getString();
    make(target, tables.getColumn("sql").getString());
    copy_rows(study, target, table, others_than(study, table, session));
  }
  SQLite::Statement others = objects_of(study, "'index', 'view', 'trigger'");
  while (others.executeStep()) {
    make(target, others.getColumn("sql").getString());
  }
  for (const char* number : {"application_id", "user_version"}) {
    target.exec(fmt::format("PRAGMA {} = {}", number,
                            study.execAndGet(fmt::format("PRAGMA {}", number)).getInt()));
  }
  transaction.commit();
  require_intact(target, path);
}

/// The UUID of the session that is no longer in the file, a study; empty if it never was.
std::optional<std::string> rebuild_without(const fs::path& file, const std::string& code) {
  fold_in_log(file);
  // A log that came back after a loss of power would be played into the new file. SQLite, too,
  // syncs the folder for a journal that it makes before that, but nowhere says so.
  sync_to_disk(folder_of(file));
  SQLite::Database study = open_as_it_is(file);
  const std::optional<FoundSession> session = session_of(study, code);
  if (!session) {
    return std::nullopt;
  }
  const TemporaryDatabase temporary(file);
  copy_others(study, session->id, temporary.path());
  temporary.replace_final();
  return session->uuid;
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path());
    }
  }
  return files;
}

/// The backups, and the study itself as the last: as long as it has the person, the others may.
std::vector<fs::path> copies_of(const fs::path& study) {
  std::vector<fs::path> copies;
  for (const fs::path& file : files_in(backup_folder(study))) {
    if (file.extension() == ".sqlite" && !file.filename().string().starts_with('.')) {
      copies.push_back(file);
    }
  }
  copies.push_back(study);
  return copies;
}

bool is_leftover(const fs::path& file, const std::vector<fs::path>& copies) {
  const std::string name = file.filename().string();
  return std::any_of(copies.begin(), copies.end(),
                     [&](const fs::path& copy) { return is_temporary_of(copy, name); });
}

/// Half-written files of killed programs hold what the study held: of its copies, and in the
/// backups' folder of backups that were never there.
void remove_leftovers(const fs::path& study, const std::vector<fs::path>& copies) {
  for (const fs::path& file : files_in(folder_of(study))) {
    if (is_leftover(file, copies)) {
      fs::remove(file);
    }
  }
  const fs::path backups = backup_folder(study);
  for (const fs::path& file : files_in(backups)) {
    if (is_temporary(file.filename().string())) {
      fs::remove(file);
    }
  }
  // Else they could come back after a loss of power.
  sync_to_disk(folder_of(study));
  if (fs::exists(backups)) {
    sync_to_disk(backups);
  }
}

/// All files that belong to the study by their names.
std::set<fs::path> files_of(const fs::path& study) {
  const std::string name = study.filename().string();
  std::set<fs::path> files;
  for (const fs::path& file : files_in(folder_of(study))) {
    if (file.filename().string().find(name) != std::string::npos) {
      files.insert(file);
    }
  }
  for (const fs::path& file : files_in(backup_folder(study))) {
    files.insert(file);
  }
  return files;
}

/// Whether a text of the study, of whoever else, has these letters in it.
bool is_in_another_text(const fs::path& file, const std::string& code) {
  SQLite::Database study = open_as_it_is(file);
  SQLite::Statement tables = objects_of(study, "'table'");
  while (tables.executeStep()) {
    const std::string table = tables.getColumn("name").getString();
    SQLite::Statement columns(study, "SELECT name FROM pragma_table_info(?) WHERE type = 'TEXT'");
    columns.bind(1, table);
    while (columns.executeStep()) {
      SQLite::Statement found(study, fmt::format("SELECT 1 FROM {} WHERE instr({}, ?) LIMIT 1",
                                                 table, columns.getColumn(0).getString()));
      found.bind(1, code);
      if (found.executeStep()) {
        return true;
      }
    }
  }
  return false;
}

/// What must not be in any byte of the files. A short code is among compressed numbers by chance,
/// and others' texts may hold it: then the UUID has to do, which stood beside it.
std::set<std::string> traces_of(const std::string& code, const std::set<std::string>& uuids,
                                const std::vector<fs::path>& copies) {
  constexpr std::size_t never_by_chance = 6;
  std::set<std::string> traces = uuids;
  const bool is_elsewhere = std::any_of(copies.begin(), copies.end(), [&](const fs::path& copy) {
    return is_in_another_text(copy, code);
  });
  if (code.size() >= never_by_chance && !is_elsewhere) {
    traces.insert(code);
  }
  return traces;
}

void require_gone(const fs::path& study, const std::set<std::string>& traces) {
  for (const fs::path& file : files_of(study)) {
    const std::string bytes = read_file(file);
    for (const std::string& trace : traces) {
      if (bytes.find(trace) != std::string::npos) {
        throw Error(file.string(), fmt::format("still holds {}", trace),
                    "look at that file, and remove it if it is an old copy");
      }
    }
  }
}

Forgotten forget(const fs::path& study, const std::string& code) {
  const ControllerLock lock(study);
  const std::vector<fs::path> copies = copies_of(study);
  for (const fs::path& copy : copies) {
    with_clear_errors(copy, [&] { require_study(copy); });
  }
  // First, so that the copies alone show what is left to do by another call.
  remove_leftovers(study, copies);
  Forgotten forgotten;
  std::set<std::string> uuids;
  for (const fs::path& copy : copies) {
    with_clear_errors(copy, [&] {
      if (const std::optional<std::string> uuid = rebuild_without(copy, code)) {
        uuids.insert(*uuid);
        ++forgotten.files;
      }
    });
  }
  if (forgotten.files == 0) {
    throw Error(study.string(), fmt::format("has no participant {}", code),
                "foveola study status says whose sessions there are");
  }
  require_gone(study, traces_of(code, uuids, copies));
  return forgotten;
}

}  // namespace

Forgotten forget_participant(const fs::path& path, const std::string& code) {
  Forgotten forgotten;
  with_clear_errors(path, [&] {
    require_study(path);
    require_writable(path);
    forgotten = forget(fs::canonical(path), code);
  });
  return forgotten;
}

}  // namespace foveola::study
