#include "study/record/write/study_store.h"

#include <functional>
#include <map>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/log/chunk.h"
#include "study/record/log/encodings.h"
#include "study/record/log/event_log.h"
#include "study/record/log/log_keeper.h"
#include "study/record/read/recorded_frames.h"
#include "study/record/schema.h"
#include "study/record/setup/same_protocol.h"
#include "study/record/sqlite/controller_lock.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/database_checks.h"
#include "study/record/sqlite/temporary_database.h"
#include "study/record/write/session_rows.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// The date of what happens at `time`, by the session's clock.
std::string utc_at(Nanoseconds time, RecordDates dates) {
  return dates == RecordDates::wall_clock ? utc_now() : utc_text(time);
}

SessionOrigin origin_of(const SessionFacts& facts, const Protocol& protocol, RecordDates dates) {
  return {
      .uuid = dates == RecordDates::wall_clock
                  ? random_uuid()
                  : study::uuid_of(fmt::format("{}\n{}\n{}\n{}\n{}", protocol.sha256, facts.devices,
                                               facts.seed, facts.design_row, facts.participant)),
      .started_utc = utc_at({}, dates)};
}

/// Makes the study at `path` if there is none; otherwise it must be the protocol's.
std::optional<Amendment> make_or_check(const fs::path& path, const Protocol& protocol,
                                       OtherProtocol other, RecordDates dates) {
  if (!fs::exists(path)) {
    create_study(path, protocol, utc_at({}, dates));
  }
  SQLite::Database checked = open_study_to_read(path);
  if (const int schema = schema_version_of(checked); schema < study_schema_version) {
    throw Error(
        path.string(),
        fmt::format("has schema {}, in which this program records no sessions", schema),
        fmt::format("continue it with {} (docs/howto/older-studies.md says how to install it), "
                    "or begin a new study",
                    program_of_oldest_schema));
  }
  require_only_own_effects(checked, path);
  return require_same_protocol(checked, path, protocol, other);
}

/// The file behind a name: another name, or another file of this name, does not change which it is.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;

  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

/// None, which is 0, if there is no file.
FileIdentity identity_of(const fs::path& path) {
  struct stat status{};
  return ::stat(path.c_str(), &status) == 0 ? FileIdentity{status.st_dev, status.st_ino}
                                            : FileIdentity{};
}

ChunkPlace place_of(std::int64_t session, std::string uuid, const AttemptKey& attempt,
                    std::uint64_t first, std::size_t count) {
  return {.session = session,
          .uuid = std::move(uuid),
          .trial = static_cast<std::int64_t>(attempt.trial),
          .attempt = attempt.attempt,
          .first = static_cast<std::int64_t>(first),
          .count = static_cast<std::int64_t>(count)};
}

/// Refuses a bad place before a lock is put there.
fs::path usable(const fs::path& path) {
  require_writable(path);
  return fs::weakly_canonical(path);
}

}  // namespace

struct StudyStore::Implementation {
  Implementation(const fs::path& path_in, const Protocol& protocol_in, OtherProtocol other,
                 RecordDates dates_in)
      : path(usable(path_in)),
        dates(dates_in),
        lock(path),
        amendment(make_or_check(path, protocol_in, other, dates)),
        identity(identity_of(path)),
        database(open_study_to_write(path)),
        log(database),
        statements(database),
        protocol(protocol_in) {}

  /// Runs `work`; all of it is on the disk when this returns, or none if it throws, but where the
  /// file was lost: that is saved with it.
  void commit(const std::function<void()>& work) {
    if (is_together) {
      work();
      return;
    }
    if (loss) {
      throw *loss;
    }
    with_clear_errors(path, [&] {
      require_same_file();
      SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
      work();
      transaction.commit();
      require_same_file();
      if (!log.holds_last_commit()) {
        lose("its log (-wal) was removed, replaced or cut off by another program");
      }
    });
  }

  /// By another name, a second program could write the file beside this one: the lock and the log
  /// are found by the name.
  void require_same_file() {
    if (identity_of(path) != identity) {
      lose("was moved, removed or replaced");
    }
  }

  /// Saves what there is beside the file, and throws Error, now and from now on.
  [[noreturn]] void lose(const std::string& what) {
    const fs::path saved = folder_of(path) / fmt::format("{}.saved-{}.sqlite", path.stem().string(),
                                                         date_in_file_name());
    std::string remedy;
    try {
      log.save(saved);
      record_file = saved;
      remedy = fmt::format("all that was recorded is in {}: go on with that file, by --resume",
                           saved.string());
    } catch (const std::exception& fault) {
      remedy = fmt::format(
          "it could not be saved in {} ({}): leave all files as they are, and make "
          "copies of them",
          saved.string(), fault.what());
    }
    loss.emplace(path.string(), what + " while it was written, and nothing more is recorded",
                 remedy);
    throw *loss;
  }

  /// Runs `work` as one commit; what it learnt of sessions that were then not made is forgotten.
  void commit_together(const std::function<void()>& work) {
    try {
      commit([&] {
        is_together = true;
        work();
      });
      is_together = false;
    } catch (...) {
      is_together = false;
      procedures.clear();
      throw;
    }
  }

  void insert(std::int64_t session, const EventEntry& entry) {
    append_event(statements, session, procedure_of_session(session),
                 {.time = entry.time, .event = entry.event, .utc = utc_at(entry.time, dates)},
                 entry.before, entry.after);
  }

  void insert(std::int64_t session, const FrameChunk& chunk) {
    insert_chunk(
        database, "frame_chunk",
        place_of(session, uuid_of(session), chunk.attempt, chunk.first, chunk.frames.size()),
        frame_encoding_name, encode_frames(chunk.frames));
  }

  void insert(std::int64_t session, const GazeChunk& chunk) {
    insert_chunk(
        database, "gaze_chunk",
        place_of(session, uuid_of(session), chunk.attempt, chunk.first, chunk.samples.size()),
        gaze_encoding_name, encode_gaze(chunk.samples));
  }

  void insert(std::int64_t session, const FilmEntry& film) {
    const auto trial = static_cast<std::int64_t>(film.attempt.trial);
    SQLite::Statement row(database, "INSERT INTO film_hash VALUES (?, ?, ?, ?, ?, ?)");
    SQLite::bind(row, session, trial, film.attempt.attempt,
                 static_cast<std::int64_t>(film.hash.frame), film.hash.sha256,
                 film_row_sha256(uuid_of(session), trial, film.attempt.attempt, film.hash));
    row.exec();
  }

  std::string uuid_of(std::int64_t session) {
    PreparedStatement row(statements, "SELECT uuid FROM session WHERE id = ?", session);
    row->executeStep();
    return row->getColumn(0).getString();
  }

  /// As it was planned when the session began.
  const Procedure& procedure_of_session(std::int64_t session) {
    const auto known = procedures.find(session);
    return known != procedures.end()
               ? known->second
               : procedures.emplace(session, recorded_procedure_of(database, session))
                     .first->second;
  }

  fs::path path;
  RecordDates dates;
  ControllerLock lock;
  std::optional<Amendment> amendment;
  FileIdentity identity;
  SQLite::Database database;
  LogKeeper log;
  std::optional<Error> loss;  ///< how the file was lost
  fs::path record_file = path;
  PreparedStatements statements;
  Protocol protocol;
  std::map<std::int64_t, Procedure> procedures;
  bool is_together = false;  ///< what is recorded belongs to one commit
};

StudyStore::StudyStore(const fs::path& path, const Protocol& protocol, OtherProtocol other,
                       RecordDates dates) {
  with_clear_errors(path, [&] {
    implementation_ = std::make_unique<Implementation>(path, protocol, other, dates);
  });
}

StudyStore::~StudyStore() {
  // If this fails, the log stays beside the file, and whoever opens the study next reads both.
  if (!implementation_->loss) {
    end_log(implementation_->database);
  }
}

const fs::path& StudyStore::record_file() const { return implementation_->record_file; }

std::string StudyStore::protocol_text() const {
  std::string text;
  with_clear_errors(implementation_->path, [&] {
    text = implementation_->database.execAndGet("SELECT protocol_text FROM study").getString();
  });
  return text;
}

const std::optional<Amendment>& StudyStore::amendment() const { return implementation_->amendment; }

void StudyStore::mark_as_part(const std::optional<ShardedStudy>& whole) {
  implementation_->commit([&] {
    SQLite::Database& database = implementation_->database;
    const std::optional<ShardedStudy> before = read_sharded_study(database);
    if (whole) {
      study::mark_as_part(database, *whole);
    } else if (before) {
      throw Error(implementation_->path.string(),
                  fmt::format("is a part of a simulated study of {} participants with the seed {}",
                              before->participants, before->seed),
                  "name a new file, or give --shard as when this file was begun");
    }
  });
}

bool StudyStore::has_participant(const std::string& code) const {
  bool found = false;
  with_clear_errors(implementation_->path,
                    [&] { found = has_session_of(implementation_->database, code); });
  return found;
}

std::vector<KnownSession> StudyStore::sessions() const {
  std::vector<KnownSession> sessions;
  with_clear_errors(implementation_->path,
                    [&] { sessions = sessions_of(implementation_->database); });
  return sessions;
}

Plan StudyStore::plan_of(std::int64_t session) const {
  Plan plan;
  with_clear_errors(implementation_->path,
                    [&] { plan = study::plan_of(implementation_->database, session); });
  return plan;
}

std::vector<LoggedEvent> StudyStore::events_of(std::int64_t session) const {
  std::vector<LoggedEvent> events;
  with_clear_errors(implementation_->path,
                    [&] { events = study::events_of(implementation_->database, session); });
  return events;
}

std::int64_t StudyStore::begin_session(const SessionFacts& facts, const Plan& plan) {
  std::int64_t session = 0;
  SQLite::Database& database = implementation_->database;
  implementation_->commit([&] {
    if (has_session_of(database, facts.participant)) {
      throw Error(implementation_->path.string(),
                  fmt::format("participant {} already has a session", facts.participant),
                  "choose another code");
    }
    const Protocol& protocol = implementation_->protocol;
    session = insert_session(database, facts, origin_of(facts, protocol, implementation_->dates),
                             plan, agenda_of(protocol, plan));
  });
  return session;
}

void StudyStore::record(std::int64_t session, const SessionEntry& entry) {
  implementation_->commit([&] {
    std::visit([&](const auto& what) { implementation_->insert(session, what); }, entry);
  });
}

void StudyStore::record_together(const std::function<void()>& work) {
  implementation_->commit_together(work);
}

void StudyStore::back_up(const fs::path& path) const {
  require_writable(path);
  with_clear_errors(path, [&] { copy_checked(implementation_->database, path); });
}

}  // namespace foveola::study
