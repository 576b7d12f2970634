// What a participant's session was when its program stopped, from the record.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/record/study_store.h"

namespace foveola::study {

struct SessionPosition {
  SessionState state;
  Nanoseconds time{0};  ///< session clock: time of the last event
  std::optional<GazeCorrection>
      correction;              ///< what the gaze goes through since the last validation
  std::string consent_sha256;  ///< of the text that was agreed to last; empty: none, or unknown
};

/// What `events` lead to. whose: names the session in errors. Throws Error if one of the events
/// does not follow from those before.
SessionPosition position_after(const Procedure& procedure, const std::vector<LoggedEvent>& events,
                               const std::string& whose);

struct SessionSoFar {
  KnownSession session;
  std::string program;  ///< the one that recorded it last, by program_name()
  Plan plan;
  SessionPosition position;
};

struct Resumption {
  SessionKind kind = SessionKind::human;  ///< of the run
  bool resumes = false;                   ///< whether the experimenter wants to go on with it
  bool despite_changes = false;           ///< even if another program began it, or the study
  bool undoes_end = false;  ///< takes back a withdrawal or an exclusion, its last event
};

/// What a session in `store` was. Throws Error if its record cannot have come about.
SessionSoFar so_far_of(const StudyStore& store, const Protocol& protocol,
                       const KnownSession& session);

/// Empty if the participant has no session yet and none is to be resumed. Throws Error, with what
/// can be done, if it is over, if it is unfinished but not to be resumed, if there is none to be
/// resumed, if it is of another kind, if another program recorded it last (of another version, or
/// built with other tools), or if another version began any session of the study.
std::optional<SessionSoFar> session_so_far(const StudyStore& store, const Protocol& protocol,
                                           const std::string& participant,
                                           const Resumption& resumption);

}  // namespace foveola::study
