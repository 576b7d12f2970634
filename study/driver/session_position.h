// Where a session goes on: at its beginning, or where its record ends.
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

}  // namespace foveola::study
