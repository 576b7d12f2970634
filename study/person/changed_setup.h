// Compares a session's equipment with its own at the beginning, or with that of earlier sessions.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/protocol.h"
#include "study/record/setup/session_setup.h"

namespace foveola::study {

struct SetupChanges {
  std::vector<std::string> demanded;  ///< changes that must be accepted before the session begins
  std::vector<std::string> others;    ///< changes that are only reported
};

/// Describes in words the changes from earlier sessions to the setup `now`, which `participant` is
/// about to use. A resumed session is compared with itself: everything but momentary facts must be
/// equal. A new session is compared with those of people: everything that `gate` demands must be
/// equal.
SetupChanges setup_changes(const std::vector<SessionSetup>& sessions,
                           const std::string& participant, const std::string& now,
                           const PreflightGate& gate);

/// Throws Error, which names the demanded changes, if there are any.
void require_same_setup(const SetupChanges& changes, const std::string& participant);

/// Returns the session's note of changes that the experimenter accepted.
std::string note_of_changes(const std::vector<std::string>& changes);

}  // namespace foveola::study
