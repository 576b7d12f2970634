#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/schema.h"
#include "study/record/setup/simulated_part.h"
#include "study/record/setup/simulation_kind.h"
#include "study/record/sqlite/damage_remedy.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/temporary_database.h"
#include "study/record/write/session_rows.h"
#include "study/record/write/table_rows.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

void require_new(const fs::path& target) {
  require_writable(target);
  if (fs::exists(target)) {
    throw Error(target.string(), "exists already", "name a new file");
  }
}

/// A text in SQL.
std::string sql_text_of(const std::string& text) {
  std::string sql = "'";
  for (const char letter : text) {
    sql += letter == '\'' ? "''" : std::string(1, letter);
  }
  return sql + "'";
}

std::optional<std::int64_t> session_where(SQLite::Database& study, const char* column,
                                          const std::string& value) {
  SQLite::Statement found(study, fmt::format("SELECT id FROM session WHERE {} = ?", column));
  found.bind(1, value);
  return found.executeStep() ? std::optional(found.getColumn(0).getInt64()) : std::nullopt;
}

/// All of a session, by whatever number and of whatever site it has in its file. The hash chain
/// covers its code.
std::string digest_of_session(SQLite::Database& study, std::int64_t session) {
  std::string digests = digest_of_rows(study, "session", fmt::format("id = {}", session),
                                       {"id", "participant", "site"});
  const auto add = [&](const auto& tables) {
    for (const char* table : tables) {
      digests += digest_of_rows(study, table, is_of_session(session), {"session"});
    }
  };
  add(plan_tables);
  add(log_tables);
  if (schema_version_of(study) < 5) {
    add(tables_before_5);
  }
  add(measured_tables);
  return sha256(digests);
}

/// site: empty if it keeps its own.
void copy_session(SQLite::Database& source, std::int64_t session, const std::string& site,
                  SQLite::Database& target) {
  Replacements replacements = {{"id", "NULL"}};
  if (!site.empty()) {
    replacements["site"] = sql_text_of(site);
    replacements["participant"] = sql_text_of(site + "-") + " || participant";
  }
  copy_rows(source, target, "session", fmt::format("id = {}", session), replacements);
  const std::string number = std::to_string(target.getLastInsertRowid());
  const auto copy = [&](const auto& tables) {
    for (const char* table : tables) {
      copy_rows(source, target, table, is_of_session(session), {{"session", number}});
    }
  };
  copy(plan_tables);
  copy(log_tables);
  if (schema_version_of(source) < 5) {
    copy(tables_before_5);
  }
  copy(measured_tables);
}

/// A session of one of the files.
struct SourceSession {
  std::size_t source = 0;  ///< the file's place in their order
  std::int64_t id = 0;
  std::string uuid;
  std::string participant;  ///< with its site
  std::string site;         ///< that it gets; empty if it keeps its own
  std::string started_utc;
  std::int64_t design_row = 0;
};

/// Puts sessions of several files into one, in the order in which they were begun. Those that were
/// begun at the same time, as in virtual time all are, come in the order of the design: so that it
/// does not matter which file they came from.
class Merging {
 public:
  /// path: where the target is to lie.
  Merging(SQLite::Database& target, const fs::path& path, const std::vector<fs::path>& sources,
          const MergeSettings& settings)
      : target_(target), path_(path), sources_(sources), settings_(settings) {}

  Merge run() {
    std::vector<SourceSession> sessions;
    for (std::size_t source = 0; source < sources_.size(); ++source) {
      with_clear_errors(sources_[source],
                        [&] { with_named_target(path_, [&] { look_at(source, sessions); }); });
    }
    std::ranges::stable_sort(sessions, {}, [](const SourceSession& session) {
      return std::tie(session.started_utc, session.design_row);
    });
    for (const SourceSession& session : sessions) {
      with_clear_errors(path_of(session), [&] { with_named_target(path_, [&] { add(session); }); });
    }
    look_for_missing();
    return result_;
  }

 private:
  const fs::path& path_of(const SourceSession& session) const { return sources_[session.source]; }

  void look_at(std::size_t source, std::vector<SourceSession>& sessions) {
    const fs::path& path = sources_[source];
    SQLite::Database study = open_study_to_read(path);
    if (source == 0) {
      make_target(study);
    }
    require_same_schema(study, path);
    require_same_study(study, path);
    add_forgotten(study);
    require_same_simulation(study, path);
    require_same_whole(study, path);
    SQLite::Statement rows(
        study, fmt::format("SELECT id, uuid, participant, started_utc, coalesce(design_row, 0)"
                           " AS design_row, {} AS own_site FROM session ORDER BY id",
                           schema_ < 5 ? "''" : "site"));
    while (rows.executeStep()) {
      const bool has_site = !rows.getColumn("own_site").getString().empty();
      const std::string site = has_site || settings_.sites.empty() ? "" : settings_.sites[source];
      sessions.push_back({.source = source,
                          .id = rows.getColumn("id").getInt64(),
                          .uuid = rows.getColumn("uuid").getString(),
                          .participant = (site.empty() ? "" : site + "-") +
                                         rows.getColumn("participant").getString(),
                          .site = site,
                          .started_utc = rows.getColumn("started_utc").getString(),
                          .design_row = rows.getColumn("design_row").getInt64()});
    }
  }

  /// Of the first file's schema, with its study.
  void make_target(SQLite::Database& study) {
    schema_ = schema_version_of(study);
    target_.exec(study_schema(schema_));
    for (const char* table : study_tables) {
      copy_rows(
          study, target_, table, "true",
          std::string(table) == "study" && schema_ >= 5
              ? Replacements{{"created_utc", "coalesce(" + earliest_date() + ", created_utc)"}}
              : Replacements{});
    }
  }

  /// Of the studies in which the sessions were begun, in SQL; NULL if there is no session.
  std::string earliest_date() const {
    std::string earliest;
    for (const fs::path& path : sources_) {
      SQLite::Database study = open_study_to_read(path);
      const std::string date =
          study
              .execAndGet(
                  "SELECT min(utc) FROM (SELECT study_created_utc AS utc FROM session UNION"
                  " ALL SELECT study_created_utc FROM forgotten)")
              .getString();
      if (!date.empty() && (earliest.empty() || date < earliest)) {
        earliest = date;
      }
    }
    return earliest.empty() ? "NULL" : sql_text_of(earliest);
  }

  void require_same_schema(SQLite::Database& study, const fs::path& path) const {
    if (const int schema = schema_version_of(study); schema != schema_) {
      throw Error(
          path.string(),
          fmt::format("has schema {}, and {} has {}", schema, sources_.front().string(), schema_),
          "merge files of one schema only");
    }
    if (schema_ < 5 && !settings_.sites.empty()) {
      throw Error(path.string(), fmt::format("has schema {}, which has no sites", schema_),
                  "leave --site out; codes that two sites have cannot be told apart in it");
    }
  }

  /// Whom one file has forgotten, no other brings back.
  void add_forgotten(SQLite::Database& study) {
    if (schema_ < 5) {
      return;
    }
    SQLite::Statement rows(study, "SELECT * FROM forgotten");
    SQLite::Statement row(target_, "INSERT OR IGNORE INTO forgotten VALUES (?, ?, ?, ?)");
    while (rows.executeStep()) {
      forgotten_.insert(rows.getColumn(0).getString());
      row.reset();
      SQLite::bind(row, rows.getColumn(0).getString(), rows.getColumn(1).getInt64(),
                   rows.getColumn(2).getString(), rows.getColumn(3).getString());
      row.exec();
    }
  }

  void add(const SourceSession& session) {
    if (open_source_ != session.source || !open_) {
      open_.emplace(open_study_to_read(path_of(session)));
      open_source_ = session.source;
    }
    add_session(*open_, session);
  }

  void require_same_study(SQLite::Database& source, const fs::path& path) {
    const std::set<std::string> but_not_when_it_was_made = {"created_utc"};
    for (const char* table : study_tables) {
      if (digest_of_rows(source, table, "true", but_not_when_it_was_made) !=
          digest_of_rows(target_, table, "true", but_not_when_it_was_made)) {
        throw Error(path.string(),
                    fmt::format("is another study than {}: its {} differs",
                                sources_.front().string(), table),
                    "merge files of one protocol only");
      }
    }
  }

  /// Results of two programs, or of two ways to simulate, would be taken for one.
  void require_same_simulation(SQLite::Database& study, const fs::path& path) {
    for (const KnownSession& session : sessions_of(study)) {
      const std::optional<SimulationKind> kind = simulation_kind_in(session.devices);
      if (session.kind != SessionKind::simulated || !kind) {
        continue;
      }
      if (!simulation_) {
        simulation_ = {.kind = *kind, .renderer = exact_name(session.build), .path = path};
      }
      require_same_kind(path.string(), {session}, simulation_->kind);
      if (const std::string renderer = exact_name(session.build);
          !kind->real_time && renderer != simulation_->renderer) {
        throw Error(path.string(),
                    fmt::format("participant {} was simulated by {}, but {} has sessions by {}",
                                session.participant, renderer, simulation_->path.string(),
                                simulation_->renderer),
                    "simulate all shards with the same version, on processors with the same "
                    "instruction set");
      }
    }
  }

  void require_same_whole(SQLite::Database& study, const fs::path& path) {
    const std::optional<ShardedStudy> whole = read_sharded_study(study);
    if (whole && whole_ && *whole != *whole_) {
      throw Error(path.string(),
                  fmt::format("is a part of {} simulated participants with seed {}, and another "
                              "file of {} with seed {}",
                              whole->participants, whole->seed, whole_->participants, whole_->seed),
                  "merge the shards of one simulation only");
    }
    whole_ = whole ? whole : whole_;
  }

  /// Of shards, together.
  void look_for_missing() {
    if (!whole_) {
      return;
    }
    result_.missing = missing_participants(target_, *whole_);
    if (result_.missing.empty()) {
      return;
    }
    if (settings_.missing == MissingParts::refuse) {
      throw Error(
          path_.string(),
          fmt::format("would lack {} of {} simulated participants: {}", result_.missing.size(),
                      whole_->participants, fmt::join(result_.missing, ", ")),
          "name the shards that have them, too, or note in the result that it is a part "
          "(--incomplete)");
    }
    mark_as_part(target_, *whole_);
  }

  void add_session(SQLite::Database& source, const SourceSession& session) {
    if (forgotten_.contains(sha256(session.uuid))) {
      ++result_.sessions_forgotten;
      return;
    }
    if (const auto known = session_where(target_, "uuid", session.uuid)) {
      require_same_session(source, session, *known);
      result_.known.insert(session.participant);
      return;
    }
    if (session_where(target_, "participant", session.participant)) {
      throw Error(path_of(session).string(),
                  fmt::format("its participant {} is another person than in another file",
                              session.participant),
                  "name the sites by --site, once for each file");
    }
    copy_session(source, session.id, session.site, target_);
    ++result_.sessions_added;
  }

  void require_same_session(SQLite::Database& source, const SourceSession& session,
                            std::int64_t known) {
    if (digest_of_session(source, session.id) != digest_of_session(target_, known)) {
      throw Error(path_of(session).string(),
                  fmt::format("its session of participant {} differs from the same one in a file"
                              " before it",
                              session.participant),
                  "leave out the older file");
    }
  }

  /// How the first simulated session was simulated.
  struct Simulation {
    SimulationKind kind;
    std::string renderer;
    fs::path path;
  };

  SQLite::Database& target_;
  const fs::path& path_;
  const std::vector<fs::path>& sources_;
  const MergeSettings& settings_;
  int schema_ = study_schema_version;
  std::set<std::string> forgotten_;  ///< SHA-256 of the sessions' UUIDs
  std::optional<Simulation> simulation_;
  std::optional<ShardedStudy> whole_;
  std::optional<SQLite::Database> open_;  ///< the file of the session that is added
  std::size_t open_source_ = 0;
  Merge result_;
};

/// temporary: the file that is to become `path`.
Merge merge_into(const std::vector<fs::path>& sources, const MergeSettings& settings,
                 const fs::path& temporary, const fs::path& path) {
  SQLite::Database target(temporary, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  target.exec("PRAGMA foreign_keys = ON");
  SQLite::Transaction transaction(target);
  const Merge merge = Merging(target, path, sources, settings).run();
  transaction.commit();
  return merge;
}

}  // namespace

Merge merge_studies(const std::vector<fs::path>& sources, const fs::path& target,
                    const MergeSettings& settings) {
  require_new(target);
  for (const fs::path& source : sources) {
    require_sound_record(source, damage_remedy);
  }
  Merge merge;
  with_clear_errors(target, [&] {
    const TemporaryDatabase temporary(target);
    merge = merge_into(sources, settings, temporary.path(), target);
    if (!temporary.take_free_name()) {
      require_new(target);
    }
  });
  return merge;
}

}  // namespace foveola::study
