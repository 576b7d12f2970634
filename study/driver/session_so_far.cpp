#include "study/driver/session_so_far.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "study/record/log/event_log.h"
#include "study/record/setup/session_programs.h"

namespace foveola::study {
namespace {

bool has_ended(Phase phase) { return SessionState{.phase = phase}.is_over(); }

std::optional<KnownSession> find_session(const StudyStore& store, const std::string& participant) {
  const std::vector<KnownSession> sessions = store.sessions();
  const auto found = std::ranges::find(sessions, participant, &KnownSession::participant);
  return found != sessions.end() ? std::optional(*found) : std::nullopt;
}

void require_persons_session(const KnownSession& session, const Resumption& resumption) {
  const std::string where = "participant " + session.participant;
  if (session.kind == SessionKind::simulated) {
    throw Error(where, "is simulated", "choose an unused code");
  }
  const bool can_be_undone = session.phase == Phase::withdrawn || session.phase == Phase::excluded;
  if (has_ended(session.phase) && !(can_be_undone && resumption.undo_end)) {
    throw Error(where, fmt::format("already has a {} session", name_of(session.phase)),
                can_be_undone ? "choose an unused code; if it was ended by mistake, --resume "
                                "with --undo-end undoes the end"
                              : "a person takes part once; choose an unused code");
  }
  if (resumption.undo_end && !can_be_undone) {
    throw Error(
        where,
        fmt::format("has a session without a withdrawal or exclusion ({})", name_of(session.phase)),
        "remove --undo-end");
  }
  if (!resumption.resumes) {
    throw Error(where, fmt::format("has an unfinished session ({})", name_of(session.phase)),
                "resume it with --resume");
  }
  if (session.kind != resumption.kind) {
    const bool is_pilot = session.kind == SessionKind::pilot;
    throw Error(where, is_pilot ? "has a rehearsal" : "has a session that counts",
                is_pilot ? "continue with --pilot" : "continue without --pilot");
  }
}

void require_same_program(const SessionSoFar& so_far) {
  if (const std::string now = program_name(build_info()); so_far.program != now) {
    throw Error(
        "participant " + so_far.session.participant,
        fmt::format("has a session of {}, but this is {}", so_far.program, now),
        "resume it with that program, or with this one by --despite-changes; the record will "
        "name both");
  }
}

}  // namespace

std::optional<SessionSoFar> session_so_far(const StudyStore& store, const Protocol& protocol,
                                           const std::string& participant,
                                           const Resumption& resumption) {
  const std::optional<KnownSession> session = find_session(store, participant);
  if (!session && resumption.resumes) {
    throw Error("--resume", "participant " + participant + " has no session to resume",
                "begin a session without --resume");
  }
  std::optional<SessionSoFar> so_far;
  if (session) {
    require_persons_session(*session, resumption);
    so_far = so_far_of(store, protocol, *session);
  }
  if (!resumption.accept_changes) {
    if (so_far) {
      require_same_program(*so_far);
    }
    require_same_version(store.record_file().string(), store.sessions(),
                         "continue with that version, or with this one by --despite-changes");
  }
  return so_far;
}

SessionSoFar so_far_of(const StudyStore& store, const Protocol& protocol,
                       const KnownSession& session) {
  const std::vector<LoggedEvent> events = store.events_of(session.id);
  SessionSoFar so_far{.session = session,
                      .program = programs_of(session, events).back(),
                      .plan = store.plan_of(session.id),
                      .position = {}};
  so_far.position = position_after(procedure_of(protocol, so_far.plan), events,
                                   "participant " + session.participant);
  return so_far;
}

SessionPosition position_after(const Procedure& procedure, const std::vector<LoggedEvent>& events,
                               const std::string& whose) {
  SessionPosition position;
  for_each_step(
      procedure, events, whose,
      [&](const LoggedEvent& logged, const SessionState& /*before*/, const SessionState& after) {
        position.state = after;
        position.time = std::max(position.time, logged.time);
        if (const auto* validated = std::get_if<GazeValidated>(&logged.event)) {
          position.correction = correction_after(*validated);
        } else if (const auto* consent = std::get_if<ConsentGiven>(&logged.event)) {
          position.consent_sha256 = consent->text_sha256;
        }
      });
  return position;
}

}  // namespace foveola::study
