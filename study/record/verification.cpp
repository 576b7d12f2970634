#include <map>
#include <stdexcept>
#include <utility>

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "study/record/chunk.h"
#include "study/record/clock_steps.h"
#include "study/record/database.h"
#include "study/record/database_checks.h"
#include "study/record/event_log.h"
#include "study/record/frame_encoding.h"
#include "study/record/gaze_encoding.h"
#include "study/record/hash_chain.h"
#include "study/record/maintenance.h"
#include "study/record/recorded_frames.h"
#include "study/record/schema.h"
#include "study/record/session_rows.h"
#include "study/record/table_rows.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// The study without its sessions.
SQLite::Database without_sessions(SQLite::Database& study) {
  SQLite::Database blank(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  blank.exec(study_schema());
  for (const char* table : study_tables) {
    copy_rows(study, blank, table);
  }
  return blank;
}

/// Adds one session's facts and plan, as they were before anything happened.
void add_session_before_events(SQLite::Database& study, std::int64_t session,
                               SQLite::Database& blank) {
  copy_rows(study, blank, "session", fmt::format("id = {}", session), {{"state", "'created'"}});
  for (const char* table : plan_tables) {
    copy_rows(study, blank, table, is_of_session(session));
  }
}

/// Looks for the faults and gaps of one session. `blank` is without_sessions(study), and is so
/// afterwards.
class SessionCheck {
 public:
  SessionCheck(SQLite::Database& study, PreparedStatements& blank, std::int64_t session,
               std::string participant, Verification& found)
      : study_(study),
        blank_(blank),
        session_(session),
        participant_(std::move(participant)),
        found_(found) {}

  void run() {
    if (chain_holds()) {
      check_what_follows();
    }
    check_chunks("frame_chunk", "first_frame", "frame_count");
    check_chunks("gaze_chunk", "first_sample", "sample_count");
    check_film_hashes();
    check_clock();
    list_gaps();
  }

 private:
  void fault(const std::string& what) { found_.faults.push_back({participant_, what}); }
  void warning(const std::string& what) { found_.warnings.push_back({participant_, what}); }
  void gap(const std::string& what) { found_.gaps.push_back({participant_, what}); }

  SQLite::Statement rows(const std::string& sql) const {
    SQLite::Statement statement(study_, sql);
    statement.bind(1, session_);
    return statement;
  }

  bool chain_holds() {
    std::string previous = hash_before_events(study_, session_);
    std::int64_t expected = 1;
    SQLite::Statement log = rows("SELECT * FROM event WHERE session = ? ORDER BY sequence");
    while (log.executeStep()) {
      const LogLine line{.sequence = log.getColumn("sequence").getInt64(),
                         .time_ns = log.getColumn("time_ns").getInt64(),
                         .utc = log.getColumn("utc").getString(),
                         .type = log.getColumn("type").getString(),
                         .payload = log.getColumn("payload").getString()};
      ++found_.events;
      previous = hash_of(previous, line);
      if (line.sequence != expected || previous != log.getColumn("hash").getString()) {
        fault(expected == 1 ? "event 1, the study, the session or its plan is not what was written"
                            : fmt::format("event {} is not what was written", expected));
        return false;
      }
      ++expected;
    }
    return true;
  }

  /// Goes through the events again, in the study without sessions, and compares.
  void check_what_follows() {
    SQLite::Database& again = blank_.database();
    const SQLite::Transaction to_be_undone(again);
    try {
      add_session_before_events(study_, session_, again);
      replay_events(blank_, session_, recorded_procedure_of(again, session_),
                    events_of(study_, session_));
      for (const char* table : event_tables) {
        if (digest_of_rows(study_, table, is_of_session(session_)) !=
            digest_of_rows(again, table, is_of_session(session_))) {
          fault(fmt::format("its rows in {} do not follow from its events", table));
        }
      }
      if (state_in(study_) != state_in(again)) {
        fault(fmt::format("its state is {}, and its events lead to {}", state_in(study_),
                          state_in(again)));
      }
    } catch (const Error& error) {
      fault(error.what());
    }
  }

  std::string state_in(SQLite::Database& database) const {
    SQLite::Statement row(database, "SELECT state FROM session WHERE id = ?");
    row.bind(1, session_);
    row.executeStep();
    return row.getColumn(0).getString();
  }

  void check_chunks(const std::string& table, const std::string& first, const std::string& count) {
    std::map<std::pair<std::int64_t, int>, std::int64_t> next;  // of each attempt
    SQLite::Statement chunks =
        rows(fmt::format("SELECT *, {} AS first, {} AS count FROM {} WHERE session = ?"
                         " ORDER BY trial, attempt, first",
                         first, count, table));
    while (chunks.executeStep()) {
      ++found_.chunks;
      const std::int64_t trial = chunks.getColumn("trial").getInt64();
      const int attempt = chunks.getColumn("attempt").getInt();
      std::int64_t& expected = next[{trial, attempt}];
      if (chunks.getColumn("first").getInt64() != expected || !is_what_was_written(chunks)) {
        fault(fmt::format("trial {}, attempt {}: {} from {} on is missing or not what was written",
                          trial, attempt, table, expected));
      }
      expected = chunks.getColumn("first").getInt64() + chunks.getColumn("count").getInt64();
    }
  }

  static bool is_what_was_written(SQLite::Statement& chunk) {
    const std::string encoding = chunk.getColumn("encoding").getString();
    const std::int64_t bytes_each =
        encoding == gaze_encoding_name ? bytes_per_gaze_sample : bytes_per_frame(encoding);
    try {
      chunk_bytes(stored_chunk(chunk), chunk.getColumn("count").getInt64() * bytes_each);
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  }

  void check_film_hashes() {
    SQLite::Statement attempts =
        rows("SELECT DISTINCT trial, attempt FROM film_hash WHERE session = ?");
    while (attempts.executeStep()) {
      try {
        film_hashes_of(study_, session_,
                       static_cast<std::size_t>(attempts.getColumn("trial").getInt64()),
                       attempts.getColumn("attempt").getInt());
      } catch (const Error& error) {
        fault(error.what());
      }
    }
  }

  void check_clock() {
    SQLite::Statement log = rows(
        "SELECT sequence, type, event.utc, coalesce(lag(event.utc) OVER (ORDER BY sequence),"
        " started_utc) FROM event JOIN session ON id = session WHERE session = ?"
        " ORDER BY sequence");
    while (log.executeStep()) {
      if (const std::optional<std::string> back =
              clock_set_back(log.getColumn(3).getString(), log.getColumn(2).getString())) {
        warning(
            fmt::format("the computer's clock was set back by {} before event {} ({}): dates are "
                        "in doubt, and times stand, since they are by another clock",
                        *back, log.getColumn(0).getInt64(), log.getColumn(1).getString()));
      }
    }
  }

  void list_gaps() {
    list_gaps(
        "SELECT 'is not over: ' || state FROM session WHERE id = ?"
        " AND state NOT IN ('completed', 'withdrawn', 'excluded', 'refused')");
    list_gaps(
        "SELECT 'trial ' || trial || ', attempt ' || attempt || ' has no frames' FROM attempt"
        " JOIN session ON session.id = attempt.session"
        " WHERE session = ?1 AND first_frame_ns IS NOT NULL"
        " AND json_extract(devices, '$.simulation.predicted') IS NOT 1 AND NOT EXISTS"
        "  (SELECT 1 FROM frame_chunk WHERE frame_chunk.session = attempt.session"
        "   AND frame_chunk.trial = attempt.trial AND frame_chunk.attempt = attempt.attempt)");
    list_gaps(
        "SELECT 'trial ' || planned_trial.trial || ' has no rated attempt' FROM planned_trial"
        " JOIN session ON session.id = planned_trial.session"
        " WHERE planned_trial.session = ? AND session.state = 'completed' AND NOT EXISTS"
        "  (SELECT 1 FROM attempt WHERE attempt.session = planned_trial.session"
        "   AND attempt.trial = planned_trial.trial AND outcome = 'rated')");
  }

  void list_gaps(const char* sql) {
    SQLite::Statement gaps = rows(sql);
    while (gaps.executeStep()) {
      gap(gaps.getColumn(0).getString());
    }
  }

  SQLite::Database& study_;
  PreparedStatements& blank_;
  std::int64_t session_;
  std::string participant_;
  Verification& found_;
};

/// Whether what SQLite itself can check is whole: the rest can then be read.
bool is_intact(SQLite::Database& study, Verification& found) {
  SQLite::Statement integrity(study, "PRAGMA integrity_check");
  while (integrity.executeStep()) {
    if (const std::string finding = integrity.getColumn(0).getString(); finding != "ok") {
      found.faults.push_back({"", finding});
    }
  }
  SQLite::Statement foreign_keys(study, "PRAGMA foreign_key_check");
  while (foreign_keys.executeStep()) {
    found.faults.push_back({"", fmt::format("a row of {} refers to one of {} that is not there",
                                            foreign_keys.getColumn(0).getString(),
                                            foreign_keys.getColumn(2).getString())});
  }
  return found.faults.empty();
}

void check_schema(SQLite::Database& study, const fs::path& path, Verification& found) {
  require_schema(study, path);
  for (const std::string& object : foreign_objects(study)) {
    found.faults.push_back({"", fmt::format("has the {}, which is not Foveola's", object)});
  }
}

void check_texts(SQLite::Database& study, Verification& found) {
  SQLite::Statement texts(study,
                          "SELECT 'the protocol' AS what, protocol_text, protocol_sha256 FROM study"
                          " UNION ALL SELECT device || ' ' || name, toml, toml_sha256"
                          " FROM study_profile");
  while (texts.executeStep()) {
    if (sha256(texts.getColumn(1).getString()) != texts.getColumn(2).getString()) {
      found.faults.push_back(
          {"", texts.getColumn(0).getString() + " is not the one that its SHA-256 names"});
    }
  }
}

/// A copy, since SQLite checks no CHECK constraints of files that it may not write. It has no name,
/// and goes to the disk only as far as it is larger than the cache.
SQLite::Database copy_to_verify(const fs::path& path) {
  require_study(path);
  SQLite::Database file = open_as_it_is(path);
  SQLite::Database copy("", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  copy.exec("PRAGMA cache_size = -65536");
  SQLite::Backup(copy, file).executeStep();
  return copy;
}

void check_sessions(SQLite::Database& study, Verification& found) {
  SQLite::Database blank = without_sessions(study);
  PreparedStatements statements(blank);
  SQLite::Statement sessions(study, "SELECT id, participant FROM session ORDER BY id");
  while (sessions.executeStep()) {
    ++found.sessions;
    SessionCheck(study, statements, sessions.getColumn(0).getInt64(),
                 sessions.getColumn(1).getString(), found)
        .run();
  }
}

Verification verify(const fs::path& path) {
  Verification found;
  SQLite::Database study = copy_to_verify(path);
  if (const std::optional<std::string> fault = size_fault(path)) {
    found.faults.push_back({"", *fault});
  }
  if (!is_intact(study, found)) {
    return found;
  }
  check_schema(study, path, found);
  check_texts(study, found);
  check_sessions(study, found);
  return found;
}

}  // namespace

Verification verify_study(const fs::path& path) {
  Verification found;
  with_clear_errors(path, [&] { found = verify(path); });
  return found;
}

}  // namespace foveola::study
