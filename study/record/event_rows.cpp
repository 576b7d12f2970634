#include "study/record/event_rows.h"

#include <cassert>
#include <string>
#include <type_traits>
#include <variant>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <nlohmann/json.hpp>

#include "study/record/gaze_rows.h"

namespace foveola::study {
namespace {

using Json = nlohmann::ordered_json;

Json payload_of(const SessionStarted& event) { return {{"validations", event.validations}}; }
Json payload_of(const GazeValidated& event) { return {{"passed", event.passed}}; }

Json payload_of(const BackgroundAnswered& event) {
  Json answers = Json::array();
  for (const Answer& answer : event.answers) {
    answers.push_back({{"question", answer.question}, {"value", answer.value}});
  }
  return {{"answers", std::move(answers)}};
}
Json payload_of(const ObjectChosen& event) { return {{"object", event.object}}; }
Json payload_of(const ArtifactsRated& event) { return {{"rating", event.rating}}; }

template <typename TimedEvent>
requires requires(TimedEvent event) { event.time; }
Json payload_of(const TimedEvent& event) { return {{"time_ns", event.time.count()}}; }
template <typename BareEvent>
requires std::is_empty_v<BareEvent> Json payload_of(const BareEvent& /*event*/) {
  return Json::object();
}

std::string payload_text(const Event& event) {
  const Json payload = std::visit([](const auto& e) { return payload_of(e); }, event);
  constexpr int on_one_line = -1;
  return payload.dump(on_one_line, ' ', false, Json::error_handler_t::replace);
}

bool is_timing(Phase phase) {
  return phase == Phase::armed || phase == Phase::outline || phase == Phase::material ||
         phase == Phase::rating;
}

/// Whether the state waits for the first frame of an attempt that `before` did not know.
bool begins_attempt(const SessionState& before, const SessionState& after) {
  return after.phase == Phase::armed &&
         (before.phase != Phase::armed || before.attempt != after.attempt);
}

/// What follows from one event of a session.
class EventRows {
 public:
  EventRows(SQLite::Database& database, std::int64_t session, const SessionState& before)
      : database_(database), session_(session), before_(before) {}

  void append_to_log(Nanoseconds time, const Event& event) const {
    insert(
        "INSERT INTO event VALUES"
        " (?1, (SELECT coalesce(max(sequence), 0) + 1 FROM event WHERE session = ?1), ?, ?, ?, ?)",
        session_, time.count(), utc_now(), name_of(event), payload_text(event));
  }

  void begin_attempt(const SessionState& after) const {
    insert("INSERT INTO attempt (session, trial, attempt, object) VALUES (?, ?, ?, ?)", session_,
           static_cast<std::int64_t>(after.trial), after.attempt, after.object);
  }

  void set_state(Phase phase) const {
    update("UPDATE session SET state = ? WHERE id = ?", name_of(phase), session_);
  }

  void operator()(const SessionStarted& /*event*/) const {}

  void operator()(const GazeValidated& event) const {
    insert_gaze_runs(database_, session_, event.runs);
  }

  void operator()(const BackgroundAnswered& event) const {
    for (const Answer& answer : event.answers) {
      insert("INSERT INTO background_answer VALUES (?, ?, ?)", session_, answer.question,
             answer.value);
    }
  }

  void operator()(const ObjectChosen& /*event*/) const {}

  void operator()(const FirstFramePresented& event) const {
    update("UPDATE attempt SET first_frame_ns = ? WHERE session = ? AND trial = ? AND attempt = ?",
           event.time.count(), session_, trial(), before_.attempt);
  }

  void operator()(const OutlineMarked& event) const { insert_mark("outline", event.time, false); }

  void operator()(const MaterialMarked& event) const { insert_mark("material", event.time, false); }

  void operator()(const TimedOut& event) const {
    insert_mark(before_.phase == Phase::outline ? "outline" : "material", event.time, true);
  }

  void operator()(const ArtifactsRated& event) const {
    insert("INSERT INTO rating VALUES (?, ?, ?, ?)", session_, trial(), before_.attempt,
           event.rating);
    end_attempt("rated");
  }

  void operator()(const RetimeRequested& /*event*/) const { end_attempt("retimed"); }
  void operator()(const Interrupted& /*event*/) const { end_attempt("interrupted"); }
  void operator()(const Withdrawn& /*event*/) const { end_attempt("withdrawn"); }

 private:
  std::int64_t trial() const { return static_cast<std::int64_t>(before_.trial); }

  void insert_mark(const char* kind, Nanoseconds time, bool is_censored) const {
    insert("INSERT INTO mark VALUES (?, ?, ?, ?, ?, ?)", session_, trial(), before_.attempt, kind,
           (time - before_.first_frame).count(), is_censored ? 1 : 0);
  }

  void end_attempt(const char* outcome) const {
    if (is_timing(before_.phase)) {
      update("UPDATE attempt SET outcome = ? WHERE session = ? AND trial = ? AND attempt = ?",
             outcome, session_, trial(), before_.attempt);
    }
  }

  template <typename... Values>
  void insert(const char* sql, const Values&... values) const {
    SQLite::Statement statement(database_, sql);
    SQLite::bind(statement, values...);
    statement.exec();
  }

  template <typename... Values>
  void update(const char* sql, const Values&... values) const {
    SQLite::Statement statement(database_, sql);
    SQLite::bind(statement, values...);
    [[maybe_unused]] const int changed = statement.exec();
    assert(changed == 1);
  }

  SQLite::Database& database_;
  std::int64_t session_;
  const SessionState& before_;
};

}  // namespace

void insert_event_rows(SQLite::Database& database, std::int64_t session, Nanoseconds time,
                       const Event& event, const SessionState& before, const SessionState& after) {
  const EventRows rows(database, session, before);
  rows.append_to_log(time, event);
  std::visit(rows, event);
  if (begins_attempt(before, after)) {
    rows.begin_attempt(after);
  }
  rows.set_state(after.phase);
}

}  // namespace foveola::study
