// From where actions are fed.
#pragma once

#include "tests/openxr/runtime/interaction_profiles.h"
#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {

/// Of what is connected, those that the application has suggested for the action. subaction: a top
/// level user path, or empty for all.
std::vector<std::string> bound_sources(const Action& action, const std::string& subaction);

/// The text of an action's subaction path, or nothing for XR_NULL_PATH. Refuses those that the
/// action was not created with.
std::string subaction_of(const Action& action, XrPath subaction);

/// Refuses what may not be asked of an action.
void require_attached(const Session& session, const Action& action);

}  // namespace foveola::test::openxr
