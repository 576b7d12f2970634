#include "renderer/headset/headset_inputs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace foveola {
namespace {

constexpr const char* eyes_profile = "/interaction_profiles/ext/eye_gaze_interaction";

/// An input of a controller.
struct Binding {
  const char* profile;  ///< after /interaction_profiles/
  const char* source;   ///< after /user/
};

/// A control that acts as a key of the keyboard.
struct ButtonDescription {
  const char* name;
  const char* shown_name;
  int key;
  std::vector<Binding> bindings;
};

constexpr const char* simple = "khr/simple_controller";
constexpr const char* touch = "oculus/touch_controller";
constexpr const char* index = "valve/index_controller";
constexpr const char* vive = "htc/vive_controller";
constexpr const char* gamepad = "microsoft/xbox_controller";

std::vector<ButtonDescription> button_descriptions() {
  return {{"mark",
           "Mark",
           GLFW_KEY_SPACE,
           {{simple, "hand/left/input/select/click"},
            {simple, "hand/right/input/select/click"},
            {touch, "hand/left/input/trigger/value"},
            {touch, "hand/right/input/trigger/value"},
            {index, "hand/left/input/trigger/click"},
            {index, "hand/right/input/trigger/click"},
            {vive, "hand/left/input/trigger/click"},
            {vive, "hand/right/input/trigger/click"},
            {gamepad, "gamepad/input/a/click"}}},
          {"answer",
           "Go on",
           GLFW_KEY_ENTER,
           {{simple, "hand/left/input/menu/click"},
            {simple, "hand/right/input/menu/click"},
            {touch, "hand/left/input/x/click"},
            {touch, "hand/right/input/a/click"},
            {index, "hand/left/input/a/click"},
            {index, "hand/right/input/a/click"},
            {vive, "hand/left/input/trackpad/click"},
            {vive, "hand/right/input/trackpad/click"},
            {gamepad, "gamepad/input/b/click"}}},
          {"next",
           "Next",
           GLFW_KEY_TAB,
           {{touch, "hand/left/input/y/click"},
            {touch, "hand/right/input/b/click"},
            {index, "hand/left/input/b/click"},
            {index, "hand/right/input/b/click"},
            {vive, "hand/left/input/squeeze/click"},
            {vive, "hand/right/input/squeeze/click"},
            {gamepad, "gamepad/input/x/click"}}},
          {"left", "Left", GLFW_KEY_LEFT, {{gamepad, "gamepad/input/dpad_left/click"}}},
          {"right", "Right", GLFW_KEY_RIGHT, {{gamepad, "gamepad/input/dpad_right/click"}}},
          {"up", "Up", GLFW_KEY_UP, {{gamepad, "gamepad/input/dpad_up/click"}}},
          {"down", "Down", GLFW_KEY_DOWN, {{gamepad, "gamepad/input/dpad_down/click"}}},
          {"pause",
           "Pause",
           GLFW_KEY_ESCAPE,
           {{touch, "hand/left/input/menu/click"}, {gamepad, "gamepad/input/menu/click"}}}};
}

const std::vector<Binding> sticks = {
    {touch, "hand/left/input/thumbstick"},     {touch, "hand/right/input/thumbstick"},
    {index, "hand/left/input/thumbstick"},     {index, "hand/right/input/thumbstick"},
    {vive, "hand/left/input/trackpad"},        {vive, "hand/right/input/trackpad"},
    {gamepad, "gamepad/input/thumbstick_left"}};

}  // namespace

HeadsetInputs::HeadsetInputs(const XrInstanceOwner& instance, XrSession session)
    : instance_(&instance), session_(session) {
  const XrFunctions& xr = instance.xr();
  XrActionSetCreateInfo set{XR_TYPE_ACTION_SET_CREATE_INFO};
  put_text("study", set.actionSetName);
  put_text("Foveola", set.localizedActionSetName);
  instance.require(xr.CreateActionSet(instance.handle(), &set, &set_), "xrCreateActionSet");
  for (const ButtonDescription& button : button_descriptions()) {
    buttons_.push_back(
        {.action = make_action(button.name, button.shown_name, XR_ACTION_TYPE_BOOLEAN_INPUT),
         .key = button.key});
  }
  stick_ = make_action("choose", "Choose", XR_ACTION_TYPE_VECTOR2F_INPUT);
  if (instance.has_eye_tracker()) {
    gaze_ = make_action("gaze", "Where the eyes look", XR_ACTION_TYPE_POSE_INPUT);
  }
  suggest_bindings();
  XrSessionActionSetsAttachInfo attached{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO};
  attached.countActionSets = 1;
  attached.actionSets = &set_;
  instance.require(xr.AttachSessionActionSets(session, &attached), "xrAttachSessionActionSets");
  if (gaze_ != XR_NULL_HANDLE) {
    XrActionSpaceCreateInfo space{XR_TYPE_ACTION_SPACE_CREATE_INFO};
    space.action = gaze_;
    space.poseInActionSpace = same_pose;
    instance.require(xr.CreateActionSpace(session, &space, &gaze_space_), "xrCreateActionSpace");
  }
}

XrAction HeadsetInputs::make_action(const char* name, const char* shown_name,
                                    XrActionType type) const {
  XrActionCreateInfo info{XR_TYPE_ACTION_CREATE_INFO};
  put_text(name, info.actionName);
  put_text(shown_name, info.localizedActionName);
  info.actionType = type;
  XrAction made = XR_NULL_HANDLE;
  instance_->require(instance_->xr().CreateAction(set_, &info, &made), "xrCreateAction");
  return made;
}

/// A runtime may not know a controller: it is then unused.
void HeadsetInputs::suggest_bindings() const {
  std::map<std::string, std::vector<XrActionSuggestedBinding>> bindings;
  const auto suggest = [&](XrAction action, const std::vector<Binding>& inputs) {
    for (const Binding& input : inputs) {
      bindings[std::string("/interaction_profiles/") + input.profile].push_back(
          {action, instance_->path((std::string("/user/") + input.source).c_str())});
    }
  };
  const std::vector<ButtonDescription> descriptions = button_descriptions();
  for (std::size_t i = 0; i < descriptions.size(); ++i) {
    suggest(buttons_[i].action, descriptions[i].bindings);
  }
  suggest(stick_, sticks);
  if (gaze_ != XR_NULL_HANDLE) {
    bindings[eyes_profile] = {{gaze_, instance_->path("/user/eyes_ext/input/gaze_ext/pose")}};
  }
  for (const auto& [profile, suggested] : bindings) {
    XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING};
    info.interactionProfile = instance_->path(profile.c_str());
    info.countSuggestedBindings = static_cast<std::uint32_t>(suggested.size());
    info.suggestedBindings = suggested.data();
    const XrResult result =
        instance_->xr().SuggestInteractionProfileBindings(instance_->handle(), &info);
    if (result != XR_ERROR_PATH_UNSUPPORTED) {
      instance_->require(result, "xrSuggestInteractionProfileBindings");
    }
  }
}

void HeadsetInputs::update(Nanoseconds now, std::vector<WindowEvent>& events) {
  const XrActiveActionSet active{set_, XR_NULL_PATH};
  XrActionsSyncInfo sync{XR_TYPE_ACTIONS_SYNC_INFO};
  sync.countActiveActionSets = 1;
  sync.activeActionSets = &active;
  const XrResult synced = instance_->xr().SyncActions(session_, &sync);
  instance_->require(synced, "xrSyncActions");
  const bool has_focus = synced != XR_SESSION_NOT_FOCUSED;
  const int pushed = has_focus ? key_of_stick() : 0;
  for (Button& button : buttons_) {
    const bool is_down = has_focus && (is_pressed(button.action) || button.key == pushed);
    if (is_down != button.is_down) {
      button.is_down = is_down;
      events.push_back({.time = now, .what = KeyMoved{.key = button.key, .is_down = is_down}});
    }
  }
  is_gaze_active_ = has_focus && gaze_ != XR_NULL_HANDLE && is_gaze_active();
}

bool HeadsetInputs::is_pressed(XrAction action) const {
  XrActionStateGetInfo get{XR_TYPE_ACTION_STATE_GET_INFO};
  get.action = action;
  XrActionStateBoolean state{XR_TYPE_ACTION_STATE_BOOLEAN};
  instance_->require(instance_->xr().GetActionStateBoolean(session_, &get, &state),
                     "xrGetActionStateBoolean");
  return state.isActive != XR_FALSE && state.currentState != XR_FALSE;
}

int HeadsetInputs::key_of_stick() const {
  constexpr float far_enough = 0.6F;
  XrActionStateGetInfo get{XR_TYPE_ACTION_STATE_GET_INFO};
  get.action = stick_;
  XrActionStateVector2f state{XR_TYPE_ACTION_STATE_VECTOR2F};
  instance_->require(instance_->xr().GetActionStateVector2f(session_, &get, &state),
                     "xrGetActionStateVector2f");
  const auto [x, y] = state.currentState;
  if (state.isActive == XR_FALSE || std::max(std::abs(x), std::abs(y)) < far_enough) {
    return 0;
  }
  if (std::abs(x) > std::abs(y)) {
    return x > 0.0F ? GLFW_KEY_RIGHT : GLFW_KEY_LEFT;
  }
  return y > 0.0F ? GLFW_KEY_UP : GLFW_KEY_DOWN;
}

bool HeadsetInputs::is_gaze_active() const {
  XrActionStateGetInfo get{XR_TYPE_ACTION_STATE_GET_INFO};
  get.action = gaze_;
  XrActionStatePose state{XR_TYPE_ACTION_STATE_POSE};
  instance_->require(instance_->xr().GetActionStatePose(session_, &get, &state),
                     "xrGetActionStatePose");
  return state.isActive != XR_FALSE;
}

std::optional<XrSpace> HeadsetInputs::gaze_space() const {
  return is_gaze_active_ ? std::optional(gaze_space_) : std::nullopt;
}

}  // namespace foveola
