#include <algorithm>
#include <string_view>

#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

/// What is new, beside what there is: a name of small letters, and one to be read.
template <typename Named>
void check_names(const Named& made, const std::vector<std::shared_ptr<Named>>& others) {
  require(!made.name.empty(), XR_ERROR_NAME_INVALID, "there is no name");
  require(std::all_of(made.name.begin(), made.name.end(),
                      [](char letter) {
                        return (letter >= 'a' && letter <= 'z') ||
                               (letter >= '0' && letter <= '9') ||
                               std::string_view("-_.").find(letter) != std::string_view::npos;
                      }),
          XR_ERROR_PATH_FORMAT_INVALID, "the name could not be a level of a path");
  require(!made.localized_name.empty(), XR_ERROR_LOCALIZED_NAME_INVALID,
          "there is no name to be read");
  for (const std::shared_ptr<Named>& other : others) {
    require(other->name != made.name, XR_ERROR_NAME_DUPLICATED, "the name is taken");
    require(other->localized_name != made.localized_name, XR_ERROR_LOCALIZED_NAME_DUPLICATED,
            "the name to be read is taken");
  }
}

std::vector<std::string> subactions_of(const XrActionCreateInfo& info) {
  std::vector<std::string> subactions;
  for (std::uint32_t i = 0; i < info.countSubactionPaths; ++i) {
    const std::string& path = text_of(info.subactionPaths[i]);
    constexpr std::string_view known[] = {"/user/hand/left", "/user/hand/right", "/user/head",
                                          "/user/gamepad", "/user/eyes_ext"};
    require(std::find(std::begin(known), std::end(known), path) != std::end(known),
            XR_ERROR_PATH_UNSUPPORTED, "a subaction path is not a top level user path");
    require(std::find(subactions.begin(), subactions.end(), path) == subactions.end(),
            XR_ERROR_PATH_UNSUPPORTED, "a subaction path is named twice");
    subactions.push_back(path);
  }
  return subactions;
}

bool is_known(XrActionType type) {
  return (type >= XR_ACTION_TYPE_BOOLEAN_INPUT && type <= XR_ACTION_TYPE_POSE_INPUT) ||
         type == XR_ACTION_TYPE_VIBRATION_OUTPUT;
}

}  // namespace

XrResult create_action_set(XrInstance instance, const XrActionSetCreateInfo* create_info,
                           XrActionSet* action_set) {
  instance_of(instance);
  const XrActionSetCreateInfo& info =
      checked(create_info, XR_TYPE_ACTION_SET_CREATE_INFO, "the information for the action set");
  XrActionSet& place = place_for(action_set, "the place for the action set");
  auto made = std::make_shared<ActionSet>();
  made->name = info.actionSetName;
  made->localized_name = info.localizedActionSetName;
  std::vector<std::shared_ptr<ActionSet>> others;
  for (const auto& [number, other] : runtime().action_sets.all()) {
    others.push_back(other);
  }
  check_names(*made, others);
  place = runtime().action_sets.add(std::move(made));
  return XR_SUCCESS;
}

XrResult destroy_action_set(XrActionSet action_set) {
  runtime().action_sets.remove(action_set);
  return XR_SUCCESS;
}

XrResult create_action(XrActionSet action_set, const XrActionCreateInfo* create_info,
                       XrAction* action) {
  const std::shared_ptr<ActionSet> set = runtime().action_sets.at(action_set);
  const XrActionCreateInfo& info =
      checked(create_info, XR_TYPE_ACTION_CREATE_INFO, "the information for the action");
  XrAction& place = place_for(action, "the place for the action");
  require(!set->is_attached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "the set is attached already");
  require(is_known(info.actionType), XR_ERROR_VALIDATION_FAILURE, "there is no such action type");
  auto made = std::make_shared<Action>();
  made->name = info.actionName;
  made->localized_name = info.localizedActionName;
  made->type = info.actionType;
  made->subactions = subactions_of(info);
  made->set = set;
  check_names(*made, set->actions);
  set->actions.push_back(made);
  place = runtime().actions.add(std::move(made));
  return XR_SUCCESS;
}

XrResult destroy_action(XrAction action) {
  runtime().actions.remove(action);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
