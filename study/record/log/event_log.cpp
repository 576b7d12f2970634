#include "study/record/log/event_log.h"

#include <stdexcept>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "study/record/log/event_json.h"
#include "study/record/schema.h"
#include "study/record/sqlite/damage_remedy.h"
#include "study/record/sqlite/stored_number.h"

namespace foveola::study {
namespace {

/// rows: a count and a hash each, in their order.
std::string count_and_digest(PreparedStatements& statements, const char* rows, std::int64_t session,
                             std::int64_t trial, std::int64_t attempt) {
  PreparedStatement row(statements, rows);
  SQLite::bind(*row, session, trial, attempt);
  std::uint64_t count = 0;  // wraps around where numbers are not what was written
  std::string hashes;
  while (row->executeStep()) {
    count += static_cast<std::uint64_t>(row->getColumn(0).getInt64());
    hashes += (hashes.empty() ? "" : "\n") + row->getColumn(1).getString();
  }
  return fmt::format(R"({{"count":{},"sha256":"{}"}})", count, sha256(hashes));
}

/// Whether the session is in an attempt at a trial.
bool is_in_attempt(const SessionState& state) {
  return state.phase == Phase::armed || state.phase == Phase::marking ||
         state.phase == Phase::rating;
}

/// Whether both are in one attempt.
bool is_same_attempt(const SessionState& a, const SessionState& b) {
  return is_in_attempt(a) && is_in_attempt(b) && a.step == b.step && a.attempt == b.attempt;
}

Error bad_event(const std::string& whose, std::int64_t sequence, const std::string& what) {
  return {fmt::format("{}, event {}", whose, sequence), what, damage_remedy};
}

/// The last line of a session's log; before the first, number 0 and the hash that it follows on.
struct LastLine {
  std::int64_t sequence = 0;
  std::string hash;
};

LastLine last_line(PreparedStatements& statements, std::int64_t session) {
  PreparedStatement last(statements,
                         "SELECT sequence, hash FROM event WHERE session = ?"
                         " ORDER BY sequence DESC LIMIT 1");
  last->bind(1, session);
  return last->executeStep()
             ? LastLine{last->getColumn(0).getInt64(), last->getColumn(1).getString()}
             : LastLine{0, hash_before_events(statements, session)};
}

}  // namespace

std::string measured_in(PreparedStatements& statements, std::int64_t session, std::int64_t trial,
                        std::int64_t attempt) {
  const auto of = [&](const char* rows) {
    return count_and_digest(statements, rows, session, trial, attempt);
  };
  return fmt::format(R"({{"frames":{},"gaze":{},"films":{}}})",
                     of("SELECT frame_count, data_sha256 FROM frame_chunk"
                        " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY first_frame"),
                     of("SELECT sample_count, data_sha256 FROM gaze_chunk"
                        " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY first_sample"),
                     of("SELECT 1, row_sha256 FROM film_hash"
                        " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY frame"));
}

EventAttempt attempt_of_event(PreparedStatements& statements, std::int64_t session,
                              const Procedure& procedure, const SessionState& before,
                              const SessionState& after) {
  if (!is_in_attempt(before) && !is_in_attempt(after)) {
    return {};
  }
  const SessionState& state = is_in_attempt(before) ? before : after;
  const auto trial = static_cast<std::int64_t>(trial_of(procedure, state).value());
  const bool ends_it = is_in_attempt(before) && !is_same_attempt(before, after);
  return {.trial = trial,
          .attempt = state.attempt,
          .measured = ends_it ? measured_in(statements, session, trial, state.attempt) : ""};
}

void insert_line(PreparedStatements& statements, std::int64_t session, const LogLine& line,
                 const std::string& hash) {
  PreparedStatement row(statements, "INSERT INTO event VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  SQLite::bind(*row, session, line.sequence, line.time_ns, line.utc, line.type, line.payload);
  if (line.trial) {
    row->bind(7, *line.trial);
    row->bind(8, *line.attempt);
  }
  if (!line.measured.empty()) {
    row->bind(9, line.measured);
  }
  row->bind(10, hash);
  row->exec();
}

void append_event(PreparedStatements& statements, std::int64_t session, const Procedure& procedure,
                  const LoggedEvent& logged, const SessionState& before,
                  const SessionState& after) {
  EventAttempt where = attempt_of_event(statements, session, procedure, before, after);
  const LastLine last = last_line(statements, session);
  const LogLine line = {.sequence = last.sequence + 1,
                        .time_ns = logged.time.count(),
                        .utc = logged.utc,
                        .type = name_of(logged.event),
                        .payload = payload_of(logged.event),
                        .trial = where.trial,
                        .attempt = where.attempt,
                        .measured = std::move(where.measured)};
  insert_line(statements, session, line, hash_of(last.hash, line, study_schema_version));
  if (after.phase != before.phase) {
    PreparedStatement state(statements, "UPDATE session SET state = ? WHERE id = ?");
    SQLite::bind(*state, name_of(after.phase), session);
    state->exec();
  }
}

std::vector<LoggedEvent> events_of(SQLite::Database& database, std::int64_t session) {
  std::vector<LoggedEvent> events;
  SQLite::Statement rows(database,
                         "SELECT sequence, time_ns, utc, type, payload FROM event"
                         " WHERE session = ? ORDER BY sequence");
  rows.bind(1, session);
  while (rows.executeStep()) {
    try {
      events.push_back({.time = time_from(rows.getColumn("time_ns").getInt64()),
                        .event = event_from(rows.getColumn("type").getString(),
                                            rows.getColumn("payload").getString()),
                        .utc = rows.getColumn("utc").getString()});
    } catch (const std::invalid_argument& fault) {
      throw bad_event(fmt::format("session {}", session), rows.getColumn("sequence").getInt64(),
                      fmt::format("cannot be read ({})", fault.what()));
    }
  }
  return events;
}

void for_each_step(const Procedure& procedure, const std::vector<LoggedEvent>& events,
                   const std::string& whose, const StepVisitor& visit) {
  SessionState state;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const LoggedEvent& logged = events[i];
    const std::optional<Transition> next = step(procedure, state, logged.event);
    if (!next) {
      throw bad_event(whose, static_cast<std::int64_t>(i) + 1,
                      fmt::format("is {} in the state {}, which cannot be", name_of(logged.event),
                                  name_of(state.phase)));
    }
    visit(logged, state, next->state);
    state = next->state;
  }
}

}  // namespace foveola::study
