#include "study/record/verify/session_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include "renderer/base/error.h"
#include "study/record/log/chunk.h"
#include "study/record/log/encodings.h"
#include "study/record/log/event_json.h"
#include "study/record/log/event_log.h"
#include "study/record/log/hash_chain.h"
#include "study/record/read/recorded_frames.h"
#include "study/record/schema.h"
#include "study/record/sqlite/stored_number.h"
#include "study/record/write/clock_steps.h"
#include "study/record/write/session_rows.h"
#include "study/record/write/table_rows.h"

namespace foveola::study {
namespace {

/// The views of schema 5 in a new database in memory, over whatever log it will hold.
SQLite::Database empty_views(SQLite::Database& study) {
  SQLite::Database views(":memory:",
                         SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | SQLite::OPEN_NOMUTEX);
  views.exec(study_schema());
  copy_rows(study, views, "study_mark");
  return views;
}

/// Whether a value that was computed is the one that was written: the last digits may be rounded
/// otherwise.
bool is_value(const SQLite::Column& computed, const SQLite::Column& written) {
  constexpr double relative_rounding = 1e-6;  // of angles in single precision
  if (!computed.isFloat() || !written.isFloat()) {
    return computed.getType() == written.getType() && computed.getString() == written.getString();
  }
  const double value = written.getDouble();
  return std::abs(computed.getDouble() - value) <=
         relative_rounding * std::max(1.0, std::abs(value));
}

bool have_same_rows(SQLite::Statement& computed, SQLite::Statement& written) {
  while (computed.executeStep()) {
    if (!written.executeStep()) {
      return false;
    }
    for (int i = 0; i < written.getColumnCount(); ++i) {
      if (!is_value(computed.getColumn(i), written.getColumn(i))) {
        return false;
      }
    }
  }
  return !written.executeStep();
}

/// Looks for the faults and gaps of one session. `views` are empty_views of a study of schema 4.
class SessionCheck {
 public:
  SessionCheck(PreparedStatements& study, PreparedStatements* views, const SessionKey& session,
               Verification& found)
      : study_(study),
        views_(views),
        session_(session.id),
        participant_(session.participant),
        schema_(schema_version_of(study.database())),
        found_(found) {}

  void run() {
    for (const auto check : {&SessionCheck::check_log, &SessionCheck::check_measurements,
                             &SessionCheck::check_clock, &SessionCheck::list_gaps}) {
      run_check(found_, participant_, [&] { (this->*check)(); });
    }
  }

 private:
  void fault(const std::string& what) { found_.faults.push_back({participant_, what}); }
  void warning(const std::string& what) { found_.warnings.push_back({participant_, what}); }
  void gap(const std::string& what) { found_.gaps.push_back({participant_, what}); }

  PreparedStatement rows(const std::string& sql) const { return rows(study_, sql); }
  PreparedStatement rows(PreparedStatements& statements, const std::string& sql) const {
    return {statements, sql, session_};
  }

  void check_log() {
    if (chain_holds()) {
      check_events();
    }
  }
  void check_measurements() {
    check_chunks("frame_chunk");
    check_chunks("gaze_chunk");
    check_film_hashes();
    check_owners();
  }

  bool chain_holds() {
    std::string previous = hash_before_events(study_, session_);
    std::int64_t expected = 1;
    PreparedStatement log = rows("SELECT * FROM event WHERE session = ? ORDER BY sequence");
    while (log->executeStep()) {
      const LogLine& line = lines_.emplace_back(log_line(*log, schema_));
      ++found_.events;
      previous = hash_of(previous, line, schema_);
      if (line.sequence != expected || previous != log->getColumn("hash").getString()) {
        fault(expected == 1 ? "event 1, the study, the session or its plan is not what was written"
                            : fmt::format("event {} is not what was written", expected));
        return false;
      }
      ++expected;
    }
    return true;
  }

  /// Goes through the events again.
  void check_events() {
    try {
      const std::vector<LoggedEvent> events = events_of(study_.database(), session_);
      if (!std::equal(events.begin(), events.end(), lines_.begin(), lines_.end(),
                      [](const LoggedEvent& logged, const LogLine& line) {
                        return payload_of(logged.event) == line.payload;
                      })) {
        fault("its events say more than this program writes of them");
      }
      const std::string state = name_of(phase_after(events));
      if (views_ != nullptr) {
        compare_tables();
      }
      PreparedStatement row = rows("SELECT state FROM session WHERE id = ?");
      row->executeStep();
      if (const std::string written = row->getColumn(0).getString(); written != state) {
        fault(fmt::format("its state is {}, and its events lead to {}", written, state));
      }
    } catch (const Error& error) {
      fault(error.what());
    }
  }

  /// The phase to which the events lead. Looks whether they say in which attempts they happened,
  /// and what was measured in those that they ended; those of schema 4, which say neither, go into
  /// the views with both.
  Phase phase_after(const std::vector<LoggedEvent>& events) {
    const Procedure procedure = recorded_procedure_of(study_.database(), session_);
    Phase phase = SessionState().phase;
    auto line = lines_.begin();
    for_each_step(
        procedure, events, fmt::format("session {}", session_),
        [&](const LoggedEvent& /*logged*/, const SessionState& before, const SessionState& after) {
          const EventAttempt expected =
              attempt_of_event(study_, session_, procedure, before, after);
          if (views_ != nullptr) {
            line->trial = expected.trial;
            line->attempt = expected.attempt;
            line->measured = expected.measured;
            insert_line(*views_, session_, *line, std::string(64, '0'));
          } else if (line->trial != expected.trial || line->attempt != expected.attempt) {
            fault(fmt::format("event {} is in another attempt than it says", line->sequence));
          } else if (line->measured != expected.measured) {
            fault(
                fmt::format("trial {}, attempt {}: its frames, gaze or films are not those "
                            "that event {} states",
                            *line->trial, *line->attempt, line->sequence));
          }
          phase = after.phase;
          ++line;
        });
    return phase;
  }

  /// Of schema 4, which has tables of what follows from the log.
  void compare_tables() {
    copy_rows(study_.database(), views_->database(), "planned_step", is_of_session(session_));
    for (const char* table : tables_before_5) {
      const std::string sql =
          fmt::format("SELECT {} FROM {} WHERE session = ? ORDER BY 1, 2, 3, 4",
                      fmt::join(columns_of(study_.database(), table), ", "), table);
      if (!have_same_rows(*rows(*views_, sql), *rows(study_, sql))) {
        fault(fmt::format("its rows in {} do not follow from its events", table));
      }
    }
  }

  void check_chunks(const std::string& table) {
    std::map<std::pair<std::int64_t, int>, std::int64_t> next;  // of each attempt
    PreparedStatement chunks =
        rows(fmt::format("SELECT {} FROM {} WHERE session = ? ORDER BY trial, attempt, first",
                         columns_of_chunk(study_.database(), table), table));
    while (chunks->executeStep()) {
      ++found_.chunks;
      const std::int64_t trial = chunks->getColumn("trial").getInt64();
      const int attempt = whole_number<int>(chunks->getColumn("attempt"));
      std::int64_t& expected = next[{trial, attempt}];
      if (chunks->getColumn("first").getInt64() != expected || !is_what_was_written(*chunks)) {
        fault(fmt::format("trial {}, attempt {}: {} from {} on is missing or not what was written",
                          trial, attempt, table, expected));
      }
      if (__builtin_add_overflow(chunks->getColumn("first").getInt64(),
                                 chunks->getColumn("count").getInt64(), &expected)) {
        return;  // nothing can follow
      }
    }
  }

  static bool is_what_was_written(SQLite::Statement& chunk) {
    const StoredChunk stored = stored_chunk(chunk);
    const std::string& encoding = stored.encoding;
    const bool is_gaze = encoding == gaze_encoding_name;
    try {
      const std::string bytes =
          chunk_bytes(stored, is_gaze ? bytes_per_gaze_sample : bytes_per_frame(encoding));
      if (is_gaze) {
        decode_gaze(bytes);
      } else {
        decode_frames(encoding, bytes);
      }
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  }

  void check_film_hashes() {
    PreparedStatement attempts =
        rows("SELECT DISTINCT trial, attempt FROM film_hash WHERE session = ?");
    while (attempts->executeStep()) {
      try {
        film_hashes_of(study_.database(), session_,
                       whole_number<std::size_t>(attempts->getColumn("trial")),
                       whole_number<int>(attempts->getColumn("attempt")));
      } catch (const Error& error) {
        fault(error.what());
      }
    }
  }

  /// Before schema 5, a foreign key says so.
  void check_owners() {
    if (schema_ < 5) {
      return;
    }
    PreparedStatement strays = rows(
        "SELECT trial, attempt FROM frame_chunk WHERE session = ?1"
        " UNION SELECT trial, attempt FROM gaze_chunk WHERE session = ?1"
        " UNION SELECT trial, attempt FROM film_hash WHERE session = ?1"
        " EXCEPT SELECT trial, attempt FROM attempt WHERE session = ?1");
    while (strays->executeStep()) {
      fault(fmt::format("trial {}, attempt {}: has frames, gaze or films, and never began",
                        strays->getColumn(0).getInt64(), strays->getColumn(1).getInt64()));
    }
  }

  void check_clock() {
    PreparedStatement session = rows("SELECT started_utc FROM session WHERE id = ?");
    session->executeStep();
    std::string before = session->getColumn(0).getString();
    PreparedStatement log = rows(
        "SELECT sequence, type, utc, CASE WHEN type = 'note_written' AND json_valid(payload)"
        " THEN json_extract(payload, '$.text') END FROM event WHERE session = ?"
        " ORDER BY sequence");
    while (log->executeStep()) {
      const std::string utc = log->getColumn(2).getString();
      const std::string note = log->getColumn(3).getString();
      if (is_note_of_running_session(note)) {
        warning(fmt::format("event {}: {}", log->getColumn(0).getInt64(), note));
      } else if (const std::optional<std::string> back = clock_set_back(before, utc)) {
        warning(
            fmt::format("the computer's clock was set back by {} before event {} ({}): dates are "
                        "in doubt, and times stand, since they are by another clock",
                        *back, log->getColumn(0).getInt64(), log->getColumn(1).getString()));
      }
      before = utc;
    }
  }

  void list_gaps() {
    list_gaps(
        "SELECT 'is not over: ' || state FROM session WHERE id = ?"
        " AND state NOT IN ('completed', 'withdrawn', 'excluded', 'refused')");
    if (schema_ >= 5) {
      list_gaps(
          "SELECT 'trial ' || trial || ', attempt ' || attempt || ' is open: no event states its"
          " frames, gaze and films' FROM attempt WHERE session = ? AND outcome = 'open'");
    }
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
    PreparedStatement gaps = rows(sql);
    while (gaps->executeStep()) {
      gap(gaps->getColumn(0).getString());
    }
  }

  PreparedStatements& study_;
  PreparedStatements* views_;
  std::int64_t session_;
  std::string participant_;
  int schema_;
  std::vector<LogLine> lines_;  ///< of the log, as far as it was read
  Verification& found_;
};

}  // namespace

void run_check(Verification& found, const std::string& participant,
               const std::function<void()>& check) {
  try {
    check();
  } catch (const SQLite::Exception& damage) {
    switch (damage.getErrorCode()) {
      case SQLITE_CORRUPT:
        found.faults.push_back({participant, damage.what()});
        break;
      case SQLITE_ERROR:
        found.faults.push_back(
            {participant, fmt::format("a value cannot be read ({})", damage.what())});
        break;
      default:
        throw;
    }
  }
}

Verification check_sessions(PreparedStatements& study, std::span<const SessionKey> sessions) {
  Verification found{.sessions = sessions.size()};
  std::optional<SQLite::Database> memory;
  std::optional<PreparedStatements> views;
  if (schema_version_of(study.database()) < 5) {
    views.emplace(memory.emplace(empty_views(study.database())));
  }
  for (const SessionKey& session : sessions) {
    SessionCheck(study, views ? &*views : nullptr, session, found).run();
  }
  return found;
}

}  // namespace foveola::study
