#include "study/driver/session_so_far.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"

namespace foveola::study {
namespace {

bool has_ended(Phase phase) { return SessionState{.phase = phase}.is_over(); }

std::optional<KnownSession> find_session(const StudyStore& store, const std::string& participant) {
  const std::vector<KnownSession> sessions = store.sessions();
  const auto found =
      std::find_if(sessions.begin(), sessions.end(),
                   [&](const KnownSession& session) { return session.participant == participant; });
  return found != sessions.end() ? std::optional(*found) : std::nullopt;
}

void require_persons_session(const KnownSession& session, const Resumption& resumption) {
  const std::string where = "participant " + session.participant;
  if (session.kind == SessionKind::simulated) {
    throw Error(where, "is a simulated one", "take a code that nobody has");
  }
  if (has_ended(session.phase)) {
    throw Error(where, fmt::format("has had a session, which is {}", name_of(session.phase)),
                "a person takes part once; take a code that nobody has");
  }
  if (!resumption.resumes) {
    throw Error(where, fmt::format("has an unfinished session ({})", name_of(session.phase)),
                "go on with it by --resume");
  }
  const std::string version = build_info().version;
  if (session.program_version != version && !resumption.despite_changes) {
    throw Error(where,
                fmt::format("began with version {} of the program; this is {}",
                            session.program_version, version),
                "go on with that version, or by --despite-changes");
  }
}

}  // namespace

std::optional<SessionSoFar> session_so_far(const StudyStore& store, const Protocol& protocol,
                                           const std::string& participant,
                                           const Resumption& resumption) {
  const std::optional<KnownSession> session = find_session(store, participant);
  if (!session) {
    if (resumption.resumes) {
      throw Error("--resume", "participant " + participant + " has no session to go on with",
                  "begin one without --resume");
    }
    return std::nullopt;
  }
  require_persons_session(*session, resumption);
  return so_far_of(store, protocol, *session);
}

SessionSoFar so_far_of(const StudyStore& store, const Protocol& protocol,
                       const KnownSession& session) {
  SessionSoFar so_far{.session = session, .plan = store.plan_of(session.id), .position = {}};
  so_far.position = position_after(procedure_of(protocol, so_far.plan), store.events_of(session.id),
                                   "participant " + session.participant);
  return so_far;
}

}  // namespace foveola::study
