#include "tests/openxr/runtime/interaction_profiles.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace foveola::test::openxr {
namespace {

using Names = std::initializer_list<const char*>;

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// As its last level says.
XrActionType type_of(const std::string& path) {
  if (path.find("/output/") != std::string::npos) {
    return XR_ACTION_TYPE_VIBRATION_OUTPUT;
  }
  if (ends_with(path, "/pose")) {
    return XR_ACTION_TYPE_POSE_INPUT;
  }
  if (ends_with(path, "/click") || ends_with(path, "/touch")) {
    return XR_ACTION_TYPE_BOOLEAN_INPUT;
  }
  return ends_with(path, "/value") || ends_with(path, "/x") || ends_with(path, "/y")
             ? XR_ACTION_TYPE_FLOAT_INPUT
             : XR_ACTION_TYPE_VECTOR2F_INPUT;
}

void add(std::vector<Source>& sources, const std::string& user, Names names) {
  for (const char* name : names) {
    const std::string path = user + "/" + name;
    sources.push_back({path, type_of(path)});
  }
}

std::vector<Source> simple_controllers() {
  std::vector<Source> sources;
  for (const char* hand : {"/user/hand/left", "/user/hand/right"}) {
    add(sources, hand,
        {"input/select/click", "input/menu/click", "input/grip/pose", "input/aim/pose",
         "output/haptic"});
  }
  return sources;
}

std::vector<Source> touch_controllers() {
  std::vector<Source> sources;
  for (const char* hand : {"/user/hand/left", "/user/hand/right"}) {
    add(sources, hand,
        {"input/squeeze/value", "input/trigger/value", "input/trigger/touch", "input/thumbstick",
         "input/thumbstick/x", "input/thumbstick/y", "input/thumbstick/click",
         "input/thumbstick/touch", "input/thumbrest/touch", "input/grip/pose", "input/aim/pose",
         "output/haptic"});
  }
  add(sources, "/user/hand/left",
      {"input/x/click", "input/x/touch", "input/y/click", "input/y/touch", "input/menu/click"});
  add(sources, "/user/hand/right",
      {"input/a/click", "input/a/touch", "input/b/click", "input/b/touch", "input/system/click"});
  return sources;
}

std::vector<Source> xbox_controller() {
  std::vector<Source> sources;
  add(sources, "/user/gamepad",
      {"input/menu/click", "input/view/click", "input/a/click", "input/b/click", "input/x/click",
       "input/y/click", "input/dpad_down/click", "input/dpad_right/click", "input/dpad_up/click",
       "input/dpad_left/click", "input/shoulder_left/click", "input/shoulder_right/click",
       "input/trigger_left/value", "input/trigger_right/value", "output/haptic_left",
       "output/haptic_right", "output/haptic_left_trigger", "output/haptic_right_trigger"});
  for (const char* stick :
       {"/user/gamepad/input/thumbstick_left", "/user/gamepad/input/thumbstick_right"}) {
    sources.push_back({stick, XR_ACTION_TYPE_VECTOR2F_INPUT});
    add(sources, stick, {"x", "y", "click"});
  }
  return sources;
}

}  // namespace

std::vector<Source> sources_of(const std::string& profile) {
  if (profile == "/interaction_profiles/khr/simple_controller") {
    return simple_controllers();
  }
  if (profile == "/interaction_profiles/oculus/touch_controller") {
    return touch_controllers();
  }
  if (profile == "/interaction_profiles/microsoft/xbox_controller") {
    return xbox_controller();
  }
  if (profile == gaze_profile) {
    return {{gaze_source, XR_ACTION_TYPE_POSE_INPUT}};
  }
  return {};
}

const Source* resolve(const std::vector<Source>& sources, const std::string& path) {
  for (const char* component : {"", "/click", "/value", "/pose"}) {
    const auto found = std::find_if(sources.begin(), sources.end(), [&](const Source& source) {
      return source.path == path + component;
    });
    if (found != sources.end()) {
      return &*found;
    }
  }
  return nullptr;
}

std::string top_level_of(const std::string& source) {
  return source.substr(0, std::min(source.find("/input/"), source.find("/output/")));
}

bool suits(XrActionType action, XrActionType source) {
  const bool is_number =
      source == XR_ACTION_TYPE_BOOLEAN_INPUT || source == XR_ACTION_TYPE_FLOAT_INPUT;
  return action == source || (is_number && (action == XR_ACTION_TYPE_BOOLEAN_INPUT ||
                                            action == XR_ACTION_TYPE_FLOAT_INPUT));
}

}  // namespace foveola::test::openxr
