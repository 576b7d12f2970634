// The extensions that the runtime knows.
#pragma once

#include <string>
#include <vector>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

struct Extension {
  const char* name;
  std::uint32_t version;
};

inline constexpr Extension extensions[] = {
    {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, XR_KHR_opengl_enable_SPEC_VERSION},
    {XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME, XR_EXT_eye_gaze_interaction_SPEC_VERSION},
    {XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME, XR_KHR_convert_timespec_time_SPEC_VERSION},
    {XR_KHR_VISIBILITY_MASK_EXTENSION_NAME, XR_KHR_visibility_mask_SPEC_VERSION},
#ifdef XR_EXT_user_presence
    {XR_EXT_USER_PRESENCE_EXTENSION_NAME, XR_EXT_user_presence_SPEC_VERSION},
#endif
};

inline std::vector<std::string> known_extensions() {
  std::vector<std::string> names;
  for (const Extension& extension : extensions) {
    names.emplace_back(extension.name);
  }
  return names;
}

}  // namespace foveola::test::openxr
