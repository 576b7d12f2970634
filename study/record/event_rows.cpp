#include "study/record/event_rows.h"

#include <cassert>
#include <stdexcept>
#include <string>
#include <variant>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "study/record/event_json.h"
#include "study/record/gaze_rows.h"
#include "study/record/hash_chain.h"
#include "study/record/schema.h"

namespace foveola::study {
namespace {

/// How an attempt ends, by the event that ends it.
struct Outcome {
  const char* operator()(const Rated& /*event*/) const { return "rated"; }
  const char* operator()(const RetimeRequested& /*event*/) const { return "retimed"; }
  const char* operator()(const PauseRequested& /*event*/) const { return "paused"; }
  const char* operator()(const Interrupted& /*event*/) const { return "interrupted"; }
  const char* operator()(const Withdrawn& /*event*/) const { return "withdrawn"; }
  const char* operator()(const Excluded& /*event*/) const { return "excluded"; }
  const char* operator()(const auto& /*event*/) const {
    throw std::logic_error("no attempt ends with this event");
  }
};

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

template <typename... Values>
void insert(PreparedStatements& statements, const char* sql, const Values&... values) {
  PreparedStatement statement(statements, sql);
  SQLite::bind(*statement, values...);
  statement->exec();
}

/// What follows from one event of a session.
class EventRows {
 public:
  EventRows(PreparedStatements& statements, std::int64_t session, const Procedure& procedure,
            std::int64_t sequence, const SessionState& before)
      : statements_(statements),
        session_(session),
        procedure_(procedure),
        sequence_(sequence),
        before_(before) {}

  void begin_attempt(const SessionState& after) const {
    insert("INSERT INTO attempt (session, trial, attempt, object) VALUES (?, ?, ?, ?)", session_,
           trial(after), after.attempt, unicode(after.object));
  }

  void end_attempt(const char* outcome) const {
    update("UPDATE attempt SET outcome = ? WHERE session = ? AND trial = ? AND attempt = ?",
           outcome, session_, trial(before_), before_.attempt);
  }

  void set_state(Phase phase) const {
    update("UPDATE session SET state = ? WHERE id = ?", name_of(phase), session_);
  }

  void operator()(const QuestionnaireAnswered& event) const {
    for (const Answer& answer : event.answers) {
      const bool is_number = std::holds_alternative<double>(answer.value);
      insert_answer("questionnaire_answer (session, step, questionnaire, question",
                    is_number ? "number" : "text", answer, session_,
                    static_cast<std::int64_t>(before_.step), event.questionnaire, answer.question);
    }
  }

  void operator()(const GazeValidated& event) const {
    insert_gaze_runs(statements_.database(), session_, sequence_, event.runs);
  }

  void operator()(const ReactionPressed& event) const {
    insert(
        "INSERT INTO reaction (session, shown_ns, pressed_ns, early, number) VALUES (?1, ?, ?,"
        " ?, (SELECT count(*) + 1 FROM reaction WHERE session = ?1))",
        session_, event.shown.count(), event.time.count(), event.time < event.shown ? 1 : 0);
  }

  void operator()(const FirstFramePresented& event) const {
    update("UPDATE attempt SET first_frame_ns = ? WHERE session = ? AND trial = ? AND attempt = ?",
           event.time.count(), session_, trial(before_), before_.attempt);
  }

  void operator()(const Marked& event) const { insert_mark(event.time, false); }
  void operator()(const TimedOut& event) const { insert_mark(event.time, true); }

  void operator()(const Rated& event) const {
    for (const Answer& answer : event.answers) {
      insert_answer("rating (session, trial, attempt, question", "value", answer, session_,
                    trial(before_), before_.attempt, answer.question);
    }
    if (event.looked_around) {
      update(
          "UPDATE attempt SET looked_around_ns = ? WHERE session = ? AND trial = ? AND attempt = ?",
          event.looked_around->count(), session_, trial(before_), before_.attempt);
    }
  }

  /// All that follows from the others is the session's state and the attempt's outcome.
  void operator()(const auto& /*event*/) const {}

 private:
  std::int64_t trial(const SessionState& state) const {
    return static_cast<std::int64_t>(trial_of(procedure_, state).value());
  }

  void insert_mark(Nanoseconds time, bool is_censored) const {
    insert(
        "INSERT INTO mark VALUES (?, ?, ?, (SELECT mark FROM study_mark WHERE position = ?), ?,"
        " ?)",
        session_, trial(before_), before_.attempt, static_cast<std::int64_t>(before_.mark),
        (time - before_.first_frame).count(), is_censored ? 1 : 0);
  }

  /// `where`: a table and its four columns of `place`; schema 4 has no column for response times.
  template <typename... Place>
  void insert_answer(const char* where, const char* value_column, const Answer& answer,
                     const Place&... place) const {
    PreparedStatement row(
        statements_,
        fmt::format("INSERT INTO {}, {}{} VALUES (?, ?, ?, ?, ?{})", where, value_column,
                    answer.response ? ", response_ns)" : ")", answer.response ? ", ?" : ""));
    SQLite::bind(*row, place...);
    if (const auto* number = std::get_if<double>(&answer.value)) {
      row->bind(5, *number);
    } else {
      row->bind(5, unicode(std::get<std::string>(answer.value)));
    }
    if (answer.response) {
      row->bind(6, static_cast<std::int64_t>(answer.response->count()));
    }
    row->exec();
  }

  template <typename... Values>
  void insert(const char* sql, const Values&... values) const {
    foveola::study::insert(statements_, sql, values...);
  }

  template <typename... Values>
  void update(const char* sql, const Values&... values) const {
    PreparedStatement statement(statements_, sql);
    SQLite::bind(*statement, values...);
    [[maybe_unused]] const int changed = statement->exec();
    assert(changed == 1);
  }

  PreparedStatements& statements_;
  std::int64_t session_;
  const Procedure& procedure_;
  std::int64_t sequence_;
  const SessionState& before_;
};

}  // namespace

std::int64_t append_to_log(PreparedStatements& statements, std::int64_t session,
                           const LoggedEvent& logged, EventAttempt where) {
  const LastLine last = last_line(statements, session);
  const LogLine line = {.sequence = last.sequence + 1,
                        .time_ns = logged.time.count(),
                        .utc = logged.utc,
                        .type = name_of(logged.event),
                        .payload = payload_of(logged.event),
                        .trial = where.trial,
                        .attempt = where.attempt,
                        .measured = std::move(where.measured)};
  PreparedStatement row(statements, "INSERT INTO event VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  SQLite::bind(*row, session, line.sequence, line.time_ns, line.utc, line.type, line.payload);
  if (line.trial) {
    row->bind(7, *line.trial);
    row->bind(8, *line.attempt);
  }
  if (!line.measured.empty()) {
    row->bind(9, line.measured);
  }
  row->bind(10, hash_of(last.hash, line, study_schema_version));
  row->exec();
  return line.sequence;
}

void insert_what_follows(PreparedStatements& statements, std::int64_t session,
                         const Procedure& procedure, std::int64_t sequence, const Event& event,
                         const SessionState& before, const SessionState& after) {
  const EventRows rows(statements, session, procedure, sequence, before);
  std::visit(rows, event);
  if (is_in_attempt(before) && !is_same_attempt(before, after)) {
    rows.end_attempt(std::visit(Outcome{}, event));
  }
  if (is_in_attempt(after) && !is_same_attempt(before, after)) {
    rows.begin_attempt(after);
  }
  if (after.phase != before.phase) {
    rows.set_state(after.phase);
  }
}

}  // namespace foveola::study
