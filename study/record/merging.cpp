#include <optional>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "study/record/database.h"
#include "study/record/maintenance.h"
#include "study/record/schema.h"
#include "study/record/table_rows.h"
#include "study/record/temporary_database.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

void require_sound_record(const fs::path& path) {
  const Verification found = verify_study(path);
  if (!found.faults.empty()) {
    const RecordFault& first = found.faults.front();
    throw Error(
        path.string(),
        (first.participant.empty() ? "" : "participant " + first.participant + ": ") + first.what,
        "restore it from a copy before it is merged");
  }
}

void require_new(const fs::path& target) {
  require_writable(target);
  if (fs::exists(target)) {
    throw Error(target.string(), "exists already", "name a new file");
  }
}

std::optional<std::int64_t> session_where(SQLite::Database& study, const char* column,
                                          const std::string& value) {
  SQLite::Statement found(study, fmt::format("SELECT id FROM session WHERE {} = ?", column));
  found.bind(1, value);
  return found.executeStep() ? std::optional(found.getColumn(0).getInt64()) : std::nullopt;
}

/// All of a session, by whatever number it has in its file.
std::string digest_of_session(SQLite::Database& study, std::int64_t session) {
  std::string digests = digest_of_rows(study, "session", fmt::format("id = {}", session), {"id"});
  const auto add = [&](const auto& tables) {
    for (const char* table : tables) {
      digests += digest_of_rows(study, table, is_of_session(session), {"session"});
    }
  };
  add(plan_tables);
  add(log_tables);
  add(following_tables);
  add(measured_tables);
  return sha256(digests);
}

void copy_session(SQLite::Database& source, std::int64_t session, SQLite::Database& target) {
  copy_rows(source, target, "session", fmt::format("id = {}", session), {{"id", "NULL"}});
  const std::string number = std::to_string(target.getLastInsertRowid());
  const auto copy = [&](const auto& tables) {
    for (const char* table : tables) {
      copy_rows(source, target, table, is_of_session(session), {{"session", number}});
    }
  };
  copy(plan_tables);
  copy(log_tables);
  copy(following_tables);
  copy(measured_tables);
}

/// Puts sessions of several files into one.
class Merging {
 public:
  Merging(SQLite::Database& target, fs::path first) : target_(target), first_(std::move(first)) {}

  void add_study(const fs::path& path) {
    SQLite::Database source = open_study_to_read(path);
    if (path == first_) {
      for (const char* table : study_tables) {
        copy_rows(source, target_, table);
      }
    }
    require_same_study(source, path);
    SQLite::Statement sessions(source, "SELECT id, uuid, participant FROM session ORDER BY id");
    while (sessions.executeStep()) {
      add_session(source, path, sessions);
    }
  }

  const Merge& result() const { return result_; }

 private:
  void require_same_study(SQLite::Database& source, const fs::path& path) {
    const std::set<std::string> but_not_when_it_was_made = {"created_utc"};
    for (const char* table : study_tables) {
      if (digest_of_rows(source, table, "true", but_not_when_it_was_made) !=
          digest_of_rows(target_, table, "true", but_not_when_it_was_made)) {
        throw Error(path.string(),
                    fmt::format("is another study than {}: its {} differs", first_.string(), table),
                    "merge files of one protocol only");
      }
    }
  }

  void add_session(SQLite::Database& source, const fs::path& path, SQLite::Statement& row) {
    const std::int64_t session = row.getColumn("id").getInt64();
    const std::string participant = row.getColumn("participant").getString();
    if (const auto known = session_where(target_, "uuid", row.getColumn("uuid").getString())) {
      require_same_session(source, path, session, *known, participant);
      ++result_.sessions_known;
      return;
    }
    if (session_where(target_, "participant", participant)) {
      throw Error(
          path.string(),
          fmt::format("its participant {} is another person than in a file before it", participant),
          "give each site codes of its own");
    }
    copy_session(source, session, target_);
    ++result_.sessions_added;
  }

  void require_same_session(SQLite::Database& source, const fs::path& path, std::int64_t session,
                            std::int64_t known, const std::string& participant) {
    if (digest_of_session(source, session) != digest_of_session(target_, known)) {
      throw Error(path.string(),
                  fmt::format("its session of participant {} differs from the same one in a file"
                              " before it",
                              participant),
                  "leave out the older file");
    }
  }

  SQLite::Database& target_;
  fs::path first_;
  Merge result_;
};

Merge merge_into(const std::vector<fs::path>& sources, const fs::path& path) {
  SQLite::Database target(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  target.exec("PRAGMA foreign_keys = ON");
  SQLite::Transaction transaction(target);
  target.exec(study_schema());
  Merging merging(target, sources.front());
  for (const fs::path& source : sources) {
    with_clear_errors(source, [&] { merging.add_study(source); });
  }
  transaction.commit();
  return merging.result();
}

}  // namespace

Merge merge_studies(const std::vector<fs::path>& sources, const fs::path& target) {
  require_new(target);
  for (const fs::path& source : sources) {
    require_sound_record(source);
  }
  Merge merge;
  with_clear_errors(target, [&] {
    const TemporaryDatabase temporary(target);
    merge = merge_into(sources, temporary.path());
    if (!temporary.take_free_name()) {
      require_new(target);
    }
  });
  return merge;
}

}  // namespace foveola::study
