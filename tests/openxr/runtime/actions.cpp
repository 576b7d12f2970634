#include <cmath>

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

/// The sources of the devices that the runtime knows, by their interaction profiles, as OpenXR 1.0
/// lists them (6.4, "Interaction Profile Paths").
const std::map<std::string, std::map<std::string, XrActionType>>& known_sources() {
  constexpr XrActionType button = XR_ACTION_TYPE_BOOLEAN_INPUT;
  constexpr XrActionType stick = XR_ACTION_TYPE_VECTOR2F_INPUT;
  static const std::map<std::string, std::map<std::string, XrActionType>> all = {
      {"/interaction_profiles/khr/simple_controller",
       {{"/user/hand/left/input/select/click", button},
        {"/user/hand/left/input/menu/click", button},
        {"/user/hand/right/input/select/click", button},
        {"/user/hand/right/input/menu/click", button}}},
      {"/interaction_profiles/microsoft/xbox_controller",
       {{"/user/gamepad/input/menu/click", button},
        {"/user/gamepad/input/view/click", button},
        {"/user/gamepad/input/a/click", button},
        {"/user/gamepad/input/b/click", button},
        {"/user/gamepad/input/x/click", button},
        {"/user/gamepad/input/y/click", button},
        {"/user/gamepad/input/dpad_down/click", button},
        {"/user/gamepad/input/dpad_right/click", button},
        {"/user/gamepad/input/dpad_up/click", button},
        {"/user/gamepad/input/dpad_left/click", button},
        {"/user/gamepad/input/shoulder_left/click", button},
        {"/user/gamepad/input/shoulder_right/click", button},
        {"/user/gamepad/input/thumbstick_left", stick},
        {"/user/gamepad/input/thumbstick_right", stick}}},
      {"/interaction_profiles/ext/eye_gaze_interaction",
       {{gaze_source, XR_ACTION_TYPE_POSE_INPUT}}}};
  return all;
}

float length_of(const XrVector2f& value) { return std::hypot(value.x, value.y); }

struct Input {
  bool is_active = false;
  XrVector2f value{0.0F, 0.0F};
};

/// Of several sources, the one that is pushed furthest.
Input input_of(XrSession handle, const XrActionStateGetInfo& info, XrActionType type) {
  const auto& session = object_of<const Session>(handle);
  const auto& action = object_of<const Action>(info.action);
  require(session.are_actions_attached, XR_ERROR_ACTIONSET_NOT_ATTACHED,
          "the action's set is not attached to the session");
  require(action.type == type, XR_ERROR_ACTION_TYPE_MISMATCH, "the action is of another type");
  Input input;
  for (const std::string& source : active_sources(session, action)) {
    const XrVector2f value = runtime().script.input_at(source, session.synchronised_s);
    input.is_active = true;
    input.value = length_of(value) > length_of(input.value) ? value : input.value;
  }
  return input;
}

XrBool32 xr_bool(bool value) { return value ? XR_TRUE : XR_FALSE; }

}  // namespace

std::vector<std::string> active_sources(const Session& session, const Action& action) {
  std::vector<std::string> connected = runtime().script.interaction_profiles;
  connected.emplace_back("/interaction_profiles/ext/eye_gaze_interaction");
  std::vector<std::string> sources;
  for (const std::string& profile : connected) {
    for (const Suggestion& suggestion : runtime().instance->suggestions[profile]) {
      if (session.are_actions_active && suggestion.action == &action) {
        sources.push_back(suggestion.source);
      }
    }
  }
  return sources;
}

XrResult CreateActionSet(XrInstance /*instance*/, const XrActionSetCreateInfo* /*info*/,
                         XrActionSet* action_set) {
  *action_set = handle_of<XrActionSet>(runtime().instance->actions);
  return XR_SUCCESS;
}

XrResult CreateAction(XrActionSet /*action_set*/, const XrActionCreateInfo* info,
                      XrAction* action) {
  require(info->countSubactionPaths == 0, XR_ERROR_PATH_UNSUPPORTED, "there are no subactions");
  *action = handle_of<XrAction>(runtime().instance->actions.emplace_back(info->actionType));
  return XR_SUCCESS;
}

XrResult SuggestInteractionProfileBindings(XrInstance /*instance*/,
                                           const XrInteractionProfileSuggestedBinding* info) {
  const std::string& profile = path_text(info->interactionProfile);
  const auto device = known_sources().find(profile);
  if (device == known_sources().end()) {
    return XR_ERROR_PATH_UNSUPPORTED;
  }
  for (std::uint32_t i = 0; i < info->countSuggestedBindings; ++i) {
    const auto& action = object_of<const Action>(info->suggestedBindings[i].action);
    const std::string& path = path_text(info->suggestedBindings[i].binding);
    const auto source = device->second.find(path);
    require(source != device->second.end() && source->second == action.type,
            XR_ERROR_PATH_UNSUPPORTED, path + " is not on this device, or is of another type");
    runtime().instance->suggestions[profile].push_back({&action, path});
  }
  return XR_SUCCESS;
}

XrResult AttachSessionActionSets(XrSession session, const XrSessionActionSetsAttachInfo* /*info*/) {
  object_of<Session>(session).are_actions_attached = true;
  return XR_SUCCESS;
}

XrResult SyncActions(XrSession session, const XrActionsSyncInfo* info) {
  auto& synchronising = object_of<Session>(session);
  require(synchronising.are_actions_attached && info->countActiveActionSets == 1,
          XR_ERROR_ACTIONSET_NOT_ATTACHED, "the action set is not attached to the session");
  synchronising.are_actions_active = synchronising.state == XR_SESSION_STATE_FOCUSED;
  synchronising.synchronised_s =
      synchronising.frames.empty() ? Frame().time_s : synchronising.frames.back().time_s;
  return synchronising.are_actions_active ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

XrResult GetActionStateBoolean(XrSession session, const XrActionStateGetInfo* info,
                               XrActionStateBoolean* state) {
  const Input input = input_of(session, *info, XR_ACTION_TYPE_BOOLEAN_INPUT);
  state->isActive = xr_bool(input.is_active);
  state->currentState = xr_bool(input.value.x >= 0.5F);
  return XR_SUCCESS;
}

XrResult GetActionStateVector2f(XrSession session, const XrActionStateGetInfo* info,
                                XrActionStateVector2f* state) {
  const Input input = input_of(session, *info, XR_ACTION_TYPE_VECTOR2F_INPUT);
  state->isActive = xr_bool(input.is_active);
  state->currentState = input.value;
  return XR_SUCCESS;
}

XrResult GetActionStatePose(XrSession session, const XrActionStateGetInfo* info,
                            XrActionStatePose* state) {
  const Input input = input_of(session, *info, XR_ACTION_TYPE_POSE_INPUT);
  const std::optional<GazeGap> gap =
      runtime().script.gaze_gap_at(object_of<Session>(session).synchronised_s);
  state->isActive = xr_bool(input.is_active && (!gap || gap->is_blink));
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
