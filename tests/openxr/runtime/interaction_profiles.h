// The devices that the runtime knows.
#pragma once

#include <string>
#include <vector>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

constexpr const char* gaze_profile = "/interaction_profiles/ext/eye_gaze_interaction";
constexpr const char* gaze_source = "/user/eyes_ext/input/gaze_ext/pose";

struct Source {
  std::string path;  ///< such as /user/hand/left/input/select/click
  XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT;
};

/// All sources of a device; none if it is unknown.
std::vector<Source> sources_of(const std::string& profile);

/// What a suggested path means, which may leave the component out. Null if there is no such source.
const Source* resolve(const std::vector<Source>& sources, const std::string& path);

/// /user/hand/left of /user/hand/left/input/select/click.
std::string top_level_of(const std::string& source);

/// Whether an action of this type can be fed from such a source.
bool suits(XrActionType action, XrActionType source);

}  // namespace foveola::test::openxr
