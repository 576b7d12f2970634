#include <algorithm>
#include <cmath>

#include "tests/openxr/runtime/bindings.h"
#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/spaces.h"
#include "tests/openxr/runtime/times.h"

namespace foveola::test::openxr {
namespace {

/// An action's state at an xrSyncActions.
struct Input {
  bool is_active = false;
  XrVector2f value{0.0F, 0.0F};
  double since_s = 0.0;  ///< the script's time of its last change
};

float length_of(const XrVector2f& value) { return std::hypot(value.x, value.y); }

/// Of several sources, the one that is pushed furthest.
Input input_of(const Synchronised& synchronised, const Action& action,
               const std::string& subaction) {
  const std::vector<std::string> sources = bound_sources(action, subaction);
  Input input;
  input.is_active = !sources.empty() && is_synchronised(synchronised, action, subaction);
  for (const std::string& source : sources) {
    const InputStep* const step = input_at(runtime().script, source, synchronised.time_s);
    if (input.is_active && step != nullptr) {
      input.since_s = std::max(input.since_s, step->time_s);
      if (length_of(step->value) > length_of(input.value)) {
        input.value = step->value;
      }
    }
  }
  return input;
}

/// What was asked about an action, and may be.
struct Question {
  const Session& session;
  std::shared_ptr<Action> action;
  std::string subaction;

  Input now() const { return input_of(session.synchronised, *action, subaction); }
  Input before() const { return input_of(session.synchronised_before, *action, subaction); }
};

Question question(XrSession session, const XrActionStateGetInfo* get_info, XrActionType type) {
  const Session& asked = session_of(session);
  const XrActionStateGetInfo& info =
      checked(get_info, XR_TYPE_ACTION_STATE_GET_INFO, "what state to get");
  const std::shared_ptr<Action> action = runtime().actions.at(info.action);
  require_attached(asked, *action);
  require(action->type == type, XR_ERROR_ACTION_TYPE_MISMATCH, "the action is of another type");
  return {asked, action, subaction_of(*action, info.subactionPath)};
}

/// What all states but those of poses have in common.
template <typename State, typename Value>
void put_state(const Question& asked, State& state, Value (*value_of)(const XrVector2f&),
               bool (*is_other)(const XrVector2f&, const XrVector2f&)) {
  const Input now = asked.now();
  const Input before = asked.before();
  state.isActive = now.is_active ? XR_TRUE : XR_FALSE;
  state.currentState = value_of(now.value);
  state.changedSinceLastSync =
      now.is_active && is_other(now.value, before.value) ? XR_TRUE : XR_FALSE;
  state.lastChangeTime = now.is_active ? time_of_script(asked.session, now.since_s) : 0;
}

XrBool32 pressed(const XrVector2f& value) { return value.x >= 0.5F ? XR_TRUE : XR_FALSE; }
float first(const XrVector2f& value) { return value.x; }
XrVector2f both(const XrVector2f& value) { return value; }
bool is_pressed_otherwise(const XrVector2f& a, const XrVector2f& b) {
  return pressed(a) != pressed(b);
}
bool is_otherwise(const XrVector2f& a, const XrVector2f& b) { return a.x != b.x || a.y != b.y; }

void require_haptic(XrSession session, const XrHapticActionInfo* haptic_info) {
  const XrHapticActionInfo& info =
      checked(haptic_info, XR_TYPE_HAPTIC_ACTION_INFO, "the haptic action");
  const std::shared_ptr<Action> action = runtime().actions.at(info.action);
  require_attached(session_of(session), *action);
  require(action->type == XR_ACTION_TYPE_VIBRATION_OUTPUT, XR_ERROR_ACTION_TYPE_MISMATCH,
          "the action is not of vibrations");
  subaction_of(*action, info.subactionPath);
}

}  // namespace

bool is_synchronised(const Synchronised& synchronised, const Action& action,
                     const std::string& subaction) {
  return synchronised.is_focused &&
         std::any_of(synchronised.sets.begin(), synchronised.sets.end(), [&](const auto& active) {
           return active.first == action.set.lock() &&
                  (active.second.empty() || subaction.empty() || active.second == subaction);
         });
}

XrResult sync_actions(XrSession session, const XrActionsSyncInfo* sync_info) {
  Session& synchronising = session_of(session);
  const XrActionsSyncInfo& info =
      checked(sync_info, XR_TYPE_ACTIONS_SYNC_INFO, "the action sets to synchronise");
  Synchronised latest;
  for (std::uint32_t i = 0; i < info.countActiveActionSets; ++i) {
    const XrActiveActionSet& active = info.activeActionSets[i];
    const std::shared_ptr<ActionSet> set = runtime().action_sets.at(active.actionSet);
    require(synchronising.attached &&
                std::find(synchronising.attached->begin(), synchronising.attached->end(), set) !=
                    synchronising.attached->end(),
            XR_ERROR_ACTIONSET_NOT_ATTACHED, "an action set is not attached to the session");
    latest.sets.emplace_back(
        set, active.subactionPath == XR_NULL_PATH ? "" : text_of(active.subactionPath));
  }
  latest.is_focused = synchronising.state == XR_SESSION_STATE_FOCUSED;
  if (!synchronising.frames.empty()) {
    latest.time_s = synchronising.frames.back().time_s;
  }
  synchronising.synchronised_before = std::exchange(synchronising.synchronised, std::move(latest));
  return synchronising.synchronised.is_focused ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

XrResult get_action_state_boolean(XrSession session, const XrActionStateGetInfo* get_info,
                                  XrActionStateBoolean* state) {
  const Question asked = question(session, get_info, XR_ACTION_TYPE_BOOLEAN_INPUT);
  put_state(asked, checked(state, XR_TYPE_ACTION_STATE_BOOLEAN, "the place for the state"), pressed,
            is_pressed_otherwise);
  return XR_SUCCESS;
}

XrResult get_action_state_float(XrSession session, const XrActionStateGetInfo* get_info,
                                XrActionStateFloat* state) {
  const Question asked = question(session, get_info, XR_ACTION_TYPE_FLOAT_INPUT);
  put_state(asked, checked(state, XR_TYPE_ACTION_STATE_FLOAT, "the place for the state"), first,
            is_otherwise);
  return XR_SUCCESS;
}

XrResult get_action_state_vector2f(XrSession session, const XrActionStateGetInfo* get_info,
                                   XrActionStateVector2f* state) {
  const Question asked = question(session, get_info, XR_ACTION_TYPE_VECTOR2F_INPUT);
  put_state(asked, checked(state, XR_TYPE_ACTION_STATE_VECTOR2F, "the place for the state"), both,
            is_otherwise);
  return XR_SUCCESS;
}

XrResult get_action_state_pose(XrSession session, const XrActionStateGetInfo* get_info,
                               XrActionStatePose* state) {
  const Question asked = question(session, get_info, XR_ACTION_TYPE_POSE_INPUT);
  const std::vector<std::string> sources = bound_sources(*asked.action, asked.subaction);
  const bool is_gaze = !sources.empty() && sources.front() == gaze_source;
  const bool is_lost =
      is_gaze && gaze_gap_at(runtime().script, asked.session.synchronised.time_s) == GazeGap::lost;
  checked(state, XR_TYPE_ACTION_STATE_POSE, "the place for the state").isActive =
      asked.now().is_active && !is_lost ? XR_TRUE : XR_FALSE;
  return XR_SUCCESS;
}

XrResult apply_haptic_feedback(XrSession session, const XrHapticActionInfo* haptic_info,
                               const XrHapticBaseHeader* feedback) {
  require_haptic(session, haptic_info);
  checked(feedback, XR_TYPE_HAPTIC_VIBRATION, "the vibration");
  return XR_SUCCESS;
}

XrResult stop_haptic_feedback(XrSession session, const XrHapticActionInfo* haptic_info) {
  require_haptic(session, haptic_info);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
