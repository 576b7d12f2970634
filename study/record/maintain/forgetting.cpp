#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "study/record/log/hash_chain.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/maintain/remaining_copies.h"
#include "study/record/schema.h"
#include "study/record/sqlite/controller_lock.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/database_checks.h"
#include "study/record/sqlite/temporary_database.h"
#include "study/record/write/table_rows.h"

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

/// What is left of a session: see schema.sql.
void add_tombstone(SQLite::Database& study, const FoundSession& session, SQLite::Database& target) {
  if (schema_version_of(study) < 5) {
    return;
  }
  SQLite::Statement last(
      study,
      "SELECT coalesce(max(sequence), 0), coalesce(hash, ''), study_created_utc"
      " FROM session LEFT JOIN event ON event.session = session.id WHERE id = ?");
  last.bind(1, session.id);
  last.executeStep();
  PreparedStatements statements(study);
  const std::string hash = last.getColumn(1).getString();
  SQLite::Statement row(target, "INSERT INTO forgotten VALUES (?, ?, ?, ?)");
  SQLite::bind(row, sha256(session.uuid), last.getColumn(0).getInt64(),
               hash.empty() ? hash_before_events(statements, session.id) : hash,
               last.getColumn(2).getString());
  row.exec();
}

/// Makes a new file of the rows that stay: one from which rows were removed keeps their bytes in
/// its free space. secure_delete fills that of the new one with zeros, whatever was in the memory.
void copy_others(SQLite::Database& study, const FoundSession& session, const fs::path& path) {
  SQLite::Database target(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  target.exec("PRAGMA secure_delete = ON");
  SQLite::Transaction transaction(target);
  SQLite::Statement tables = objects_of(study, "'table'");
  while (tables.executeStep()) {
    const std::string table = tables.getColumn("name").getString();
    make(target, tables.getColumn("sql").getString());
    copy_rows(study, target, table, others_than(study, table, session.id));
  }
  add_tombstone(study, session, target);
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
  copy_others(study, *session, temporary.path());
  temporary.replace_final();
  return session->uuid;
}

/// Those of a folder and of those in it.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    if (entry->is_regular_file()) {
      files.push_back(entry->path());
    }
  }
  return files;
}

/// The backups, and the study itself as the last: as long as it has the person, the others may.
std::vector<fs::path> copies_of(const fs::path& study) {
  std::vector<fs::path> copies = backups_of(study);
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

/// What people typed into the events of others.
std::vector<std::string> mentions_in(const fs::path& path, const std::string& code) {
  std::vector<std::string> mentions;
  SQLite::Database study = open_as_it_is(path);
  SQLite::Statement texts(
      study,
      "SELECT participant, sequence, atom FROM session JOIN event ON event.session = session.id,"
      " json_tree(payload) WHERE json_tree.type = 'text' AND instr(atom, ?)"
      " ORDER BY participant, sequence");
  texts.bind(1, code);
  while (texts.executeStep()) {
    if (has_word(texts.getColumn("atom").getString(), code)) {
      mentions.push_back(fmt::format("event {} of {}", texts.getColumn("sequence").getString(),
                                     texts.getColumn("participant").getString()));
    }
  }
  return mentions;
}

Forgotten forget(const fs::path& study, const std::string& code) {
  const ControllerLock lock(study);
  const std::vector<fs::path> copies = copies_of(study);
  // First, so that the copies alone show what is left to do by another call.
  remove_leftovers(study, copies);
  Forgotten forgotten;
  std::set<std::string> uuids;
  for (const fs::path& copy : copies) {
    try {
      with_clear_errors(copy, [&] {
        require_study(copy);
        if (const std::optional<std::string> uuid = rebuild_without(copy, code)) {
          uuids.insert(*uuid);
          ++forgotten.files;
        }
      });
    } catch (const Error& fault) {
      if (copy == study) {
        throw;
      }
      forgotten.remaining.push_back({copy, fault.what()});
    }
  }
  for (RemainingCopy& copy : remaining_copies(study, code, uuids)) {
    if (std::ranges::find(forgotten.remaining, copy.file, &RemainingCopy::file) ==
        forgotten.remaining.end()) {
      forgotten.remaining.push_back(std::move(copy));
    }
  }
  std::ranges::sort(forgotten.remaining, {}, &RemainingCopy::file);
  forgotten.mentions = mentions_in(study, code);
  if (forgotten.files == 0 && forgotten.remaining.empty()) {
    throw Error(study.string(), fmt::format("has no participant {}", code),
                "foveola study status says whose sessions there are");
  }
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
