// Restores the state of a participant's stopped session from the record.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/record/write/study_store.h"

namespace foveola::study {

struct SessionPosition {
  SessionState state;
  Nanoseconds time{0};                       ///< session clock: time of the last event
  std::optional<GazeCorrection> correction;  ///< the gaze's correction since the last validation
  std::string consent_sha256;  ///< of the last text that was agreed to; empty: none, or unknown
};

/// Returns the state after `events`. whose: names the session in errors. Throws Error if an event
/// does not follow from the earlier ones.
SessionPosition position_after(const Procedure& procedure, const std::vector<LoggedEvent>& events,
                               const std::string& whose);

struct SessionSoFar {
  KnownSession session;
  std::string program;  ///< program_name() of the last program that recorded it
  Plan plan;
  SessionPosition position;
};

struct Resumption {
  SessionKind kind = SessionKind::human;  ///< of the run
  bool resumes = false;                   ///< whether the experimenter asks to resume it
  bool accept_changes = false;            ///< even if another program began it, or the study
  bool undo_end = false;                  ///< undoes a withdrawal or an exclusion, its last event
};

/// Returns a session in `store`. Throws Error if its record is impossible.
SessionSoFar so_far_of(const StudyStore& store, const Protocol& protocol,
                       const KnownSession& session);

/// Returns the participant's session; empty if there is none and none is to be resumed. Throws
/// Error, with the remedy, if it is over, if it is unfinished but not to be resumed, if there is
/// none to be resumed, or if it is of another kind. Also if another program recorded it last (of
/// another version, or built with other tools), or if another version began any session of the
/// study.
std::optional<SessionSoFar> session_so_far(const StudyStore& store, const Protocol& protocol,
                                           const std::string& participant,
                                           const Resumption& resumption);

}  // namespace foveola::study
