#include "study/record/event_log.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/damage_remedy.h"
#include "study/record/event_json.h"
#include "study/record/event_rows.h"
#include "study/record/stored_number.h"

namespace foveola::study {
namespace {

Error bad_event(const std::string& whose, std::int64_t sequence, const std::string& what) {
  return {fmt::format("{}, event {}", whose, sequence), what, damage_remedy};
}

std::string name_of_session(std::int64_t session) { return fmt::format("session {}", session); }

}  // namespace

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
      throw bad_event(name_of_session(session), rows.getColumn("sequence").getInt64(),
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

void replay_events(PreparedStatements& statements, std::int64_t session, const Procedure& procedure,
                   const std::vector<LoggedEvent>& events) {
  std::int64_t sequence = 0;
  for_each_step(
      procedure, events, name_of_session(session),
      [&](const LoggedEvent& logged, const SessionState& before, const SessionState& after) {
        insert_what_follows(statements, session, procedure, ++sequence, logged.event, before,
                            after);
      });
}

}  // namespace foveola::study
