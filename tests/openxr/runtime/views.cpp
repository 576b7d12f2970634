#include "tests/openxr/runtime/views.h"

#include <glm/trigonometric.hpp>

#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/system.h"
#include "tests/openxr/runtime/times.h"
#include "tests/openxr/runtime/two_calls.h"

namespace foveola::test::openxr {
namespace {

Pose eye_in_head(const ScriptedEye& eye) { return turned({eye.cant_deg, 0.0, 0.0}, eye.offset_m); }

XrFovf fov_of(const FovDeg& fov) {
  return {static_cast<float>(glm::radians(fov.left)), static_cast<float>(glm::radians(fov.right)),
          static_cast<float>(glm::radians(fov.up)), static_cast<float>(glm::radians(fov.down))};
}

}  // namespace

std::vector<XrView> views_in(const Session& session, const Space& space, XrTime time) {
  Space head;
  const Pose head_in_space =
      inverse(locate(session, space, time).pose) * locate(session, head, time).pose;
  std::vector<XrView> views;
  for (const ScriptedEye& eye : runtime().script.eyes) {
    views.push_back({XR_TYPE_VIEW, nullptr, for_application(head_in_space * eye_in_head(eye)),
                     fov_of(eye.fov_deg)});
  }
  return views;
}

XrResult locate_views(XrSession session, const XrViewLocateInfo* locate_info,
                      XrViewState* view_state, std::uint32_t capacity, std::uint32_t* count,
                      XrView* views) {
  Session& located = session_of(session);
  const XrViewLocateInfo& info =
      checked(locate_info, XR_TYPE_VIEW_LOCATE_INFO, "what views to locate");
  XrViewState& state = checked(view_state, XR_TYPE_VIEW_STATE, "the place for the views' state");
  require_stereo(info.viewConfigurationType);
  require_time(located, info.displayTime);
  const std::shared_ptr<Space> space = runtime().spaces.at(info.space);
  const bool is_tracked =
      is_head_tracked(runtime().script, script_time_s(located, info.displayTime));
  const bool is_valid = locate(located, *space, info.displayTime).is_valid;
  state.viewStateFlags = 0;
  if (is_valid) {
    state.viewStateFlags |= XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
    if (is_tracked) {
      state.viewStateFlags |=
          XR_VIEW_STATE_ORIENTATION_TRACKED_BIT | XR_VIEW_STATE_POSITION_TRACKED_BIT;
    }
  }
  give_structures(views_in(located, *space, info.displayTime), XR_TYPE_VIEW, capacity, count,
                  views);
  if (capacity > 0) {
    located.times_of_views.insert(info.displayTime);
  }
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
