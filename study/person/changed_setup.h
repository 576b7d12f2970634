// What a session runs on, compared with what it, or those before it, ran on.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/protocol.h"
#include "study/record/session_setup.h"

namespace foveola::study {

struct SetupChanges {
  std::vector<std::string> demanded;  ///< that have to be accepted before the session begins
  std::vector<std::string> others;    ///< that are to be known
};

/// Of a session by `participant` that is to run on `now`, in words. A session that is continued is
/// compared with itself, and all has to be the same but what depends on the moment; one that begins
/// is compared with those of people, and what `gate` demands has to be the same.
SetupChanges setup_changes(const std::vector<SessionSetup>& sessions,
                           const std::string& participant, const std::string& now,
                           const PreflightGate& gate);

/// Throws Error, which names them, if there are demanded ones.
void require_same_setup(const SetupChanges& changes, const std::string& participant);

/// The note of a session that has them nevertheless.
std::string note_of_changes(const std::vector<std::string>& changes);

}  // namespace foveola::study
