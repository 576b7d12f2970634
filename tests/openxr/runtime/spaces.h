// Where things are.
#pragma once

#include <optional>

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {

/// In the room, if it is known at all.
struct Located {
  Pose pose;
  bool is_valid = true;
  bool is_tracked = true;
  XrTime sample_time = 0;  ///< of eyes, or 0
};

Located locate(const Session& session, const Space& space, XrTime time);

/// Whether the last xrSyncActions made the action's set active, while the session was focused.
bool is_synchronised(const Synchronised& synchronised, const Action& action,
                     const std::string& subaction);

}  // namespace foveola::test::openxr
