#include "tests/openxr/runtime/bindings.h"

#include <algorithm>

#include <fmt/format.h>

#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/system.h"
#include "tests/openxr/runtime/two_calls.h"

namespace foveola::test::openxr {
namespace {

std::vector<std::string> connected_profiles() {
  std::vector<std::string> profiles = runtime().script.interaction_profiles;
  if (has_eye_tracker()) {
    profiles.emplace_back(gaze_profile);
  }
  return profiles;
}

bool has_user(const std::string& profile, const std::string& top_level) {
  const std::vector<Source> sources = sources_of(profile);
  return std::any_of(sources.begin(), sources.end(),
                     [&](const Source& source) { return top_level_of(source.path) == top_level; });
}

/// What a hand holds, or the like: the first that is connected and has suggestions, or empty.
std::string active_profile(const std::string& top_level) {
  for (const std::string& profile : connected_profiles()) {
    if (has_user(profile, top_level) && runtime().instance->suggestions.contains(profile)) {
      return profile;
    }
  }
  return "";
}

bool includes(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

Suggestion checked_suggestion(const std::vector<Source>& sources,
                              const XrActionSuggestedBinding& binding) {
  const std::string& path = text_of(binding.binding);
  Suggestion suggestion{runtime().actions.at(binding.action), ""};
  const std::shared_ptr<ActionSet> set = suggestion.action->set.lock();
  require(!set || !set->is_attached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED,
          "the action's set is attached already");
  const Source* const source = resolve(sources, path);
  if (source == nullptr) {
    throw Refusal(XR_ERROR_PATH_UNSUPPORTED, path + " is not on this device");
  }
  if (!suits(suggestion.action->type, source->type)) {
    throw Refusal(XR_ERROR_PATH_UNSUPPORTED,
                  fmt::format("{} does not suit the action '{}'", path, suggestion.action->name));
  }
  suggestion.source = source->path;
  return suggestion;
}

void queue_profile_change(XrSession session) {
  XrEventDataInteractionProfileChanged changed{XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED};
  changed.session = session;
  queue_event(changed);
}

}  // namespace

std::vector<std::string> bound_sources(const Action& action, const std::string& subaction) {
  std::vector<std::string> sources;
  for (const auto& [profile, suggestions] : runtime().instance->suggestions) {
    for (const Suggestion& suggestion : suggestions) {
      const std::string top_level = top_level_of(suggestion.source);
      const bool is_of_subaction =
          action.subactions.empty() || includes(action.subactions, top_level);
      if (suggestion.action.get() == &action && is_of_subaction &&
          (subaction.empty() || subaction == top_level) && active_profile(top_level) == profile) {
        sources.push_back(suggestion.source);
      }
    }
  }
  return sources;
}

std::string subaction_of(const Action& action, XrPath subaction) {
  if (subaction == XR_NULL_PATH) {
    return "";
  }
  require(includes(action.subactions, text_of(subaction)), XR_ERROR_PATH_UNSUPPORTED,
          "the action was not created with this subaction path");
  return text_of(subaction);
}

void require_attached(const Session& session, const Action& action) {
  const std::shared_ptr<ActionSet> set = action.set.lock();
  require(session.attached && std::find(session.attached->begin(), session.attached->end(), set) !=
                                  session.attached->end(),
          XR_ERROR_ACTIONSET_NOT_ATTACHED, "the action's set is not attached to the session");
}

XrResult suggest_interaction_profile_bindings(
    XrInstance instance, const XrInteractionProfileSuggestedBinding* suggested) {
  Instance& owner = instance_of(instance);
  const XrInteractionProfileSuggestedBinding& info =
      checked(suggested, XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING, "the suggested bindings");
  const std::string profile = text_of(info.interactionProfile);
  const std::vector<Source> sources = sources_of(profile);
  if (sources.empty() ||
      (profile == gaze_profile && !is_enabled(XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME))) {
    throw Refusal(XR_ERROR_PATH_UNSUPPORTED, profile + " is not known, or not enabled");
  }
  require(info.countSuggestedBindings > 0 && info.suggestedBindings != nullptr,
          XR_ERROR_VALIDATION_FAILURE, "there are no bindings");
  std::vector<Suggestion> suggestions;
  for (std::uint32_t i = 0; i < info.countSuggestedBindings; ++i) {
    suggestions.push_back(checked_suggestion(sources, info.suggestedBindings[i]));
  }
  owner.suggestions[profile] = std::move(suggestions);
  return XR_SUCCESS;
}

XrResult attach_session_action_sets(XrSession session,
                                    const XrSessionActionSetsAttachInfo* attach_info) {
  Session& attaching = session_of(session);
  const XrSessionActionSetsAttachInfo& info =
      checked(attach_info, XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO, "the action sets to attach");
  require(!attaching.attached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED,
          "the session has its action sets already");
  require(info.countActionSets > 0 && info.actionSets != nullptr, XR_ERROR_VALIDATION_FAILURE,
          "there are no action sets");
  std::vector<std::shared_ptr<ActionSet>> sets;
  for (std::uint32_t i = 0; i < info.countActionSets; ++i) {
    sets.push_back(runtime().action_sets.at(info.actionSets[i]));
  }
  for (const std::shared_ptr<ActionSet>& set : sets) {
    set->is_attached = true;
  }
  attaching.attached = std::move(sets);
  queue_profile_change(session);
  return XR_SUCCESS;
}

XrResult get_current_interaction_profile(XrSession session, XrPath top_level,
                                         XrInteractionProfileState* profile) {
  const Session& asked = session_of(session);
  XrInteractionProfileState& place =
      checked(profile, XR_TYPE_INTERACTION_PROFILE_STATE, "the place for the profile");
  require(asked.attached.has_value(), XR_ERROR_ACTIONSET_NOT_ATTACHED,
          "no action sets are attached to the session");
  const std::string active = active_profile(text_of(top_level));
  place.interactionProfile = active.empty() ? XR_NULL_PATH : path_of(active);
  return XR_SUCCESS;
}

XrResult enumerate_bound_sources_for_action(
    XrSession session, const XrBoundSourcesForActionEnumerateInfo* enumerate_info,
    std::uint32_t capacity, std::uint32_t* count, XrPath* sources) {
  const Session& asked = session_of(session);
  const XrBoundSourcesForActionEnumerateInfo& info =
      checked(enumerate_info, XR_TYPE_BOUND_SOURCES_FOR_ACTION_ENUMERATE_INFO, "what to list");
  const std::shared_ptr<Action> action = runtime().actions.at(info.action);
  require_attached(asked, *action);
  std::vector<XrPath> paths;
  for (const std::string& source : bound_sources(*action, "")) {
    paths.push_back(path_of(source));
  }
  give_items(paths, capacity, count, sources);
  return XR_SUCCESS;
}

XrResult get_input_source_localized_name(XrSession session,
                                         const XrInputSourceLocalizedNameGetInfo* get_info,
                                         std::uint32_t capacity, std::uint32_t* count,
                                         char* buffer) {
  const Session& asked = session_of(session);
  const XrInputSourceLocalizedNameGetInfo& info =
      checked(get_info, XR_TYPE_INPUT_SOURCE_LOCALIZED_NAME_GET_INFO, "what to name");
  require(asked.attached.has_value(), XR_ERROR_ACTIONSET_NOT_ATTACHED,
          "no action sets are attached to the session");
  require(info.whichComponents != 0, XR_ERROR_VALIDATION_FAILURE,
          "no part of the name is asked for");
  give_text(text_of(info.sourcePath), capacity, count, buffer);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
