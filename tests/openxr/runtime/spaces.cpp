#include "tests/openxr/runtime/spaces.h"

#include "tests/openxr/runtime/bindings.h"
#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/times.h"
#include "tests/openxr/runtime/two_calls.h"

namespace foveola::test::openxr {
namespace {

const Pose& local_origin(const Session& session, XrTime time) {
  const Pose* origin = &session.local_origins.front().second;
  for (const auto& [from, pose] : session.local_origins) {
    origin = from <= time ? &pose : origin;
  }
  return *origin;
}

Located locate_head(const Session& session, XrTime time) {
  const double time_s = script_time_s(session, time);
  return {head_at(runtime().script, time_s), true, is_head_tracked(runtime().script, time_s)};
}

/// The latest frame with which eyes were sampled, at that time or before it.
const Frame& frame_of_sample(const Session& session, XrTime time) {
  const Frame* latest = &session.frames.front();
  for (const Frame& frame : session.frames) {
    latest = frame.sample_time <= time ? &frame : latest;
  }
  return *latest;
}

XrTime told_sample_time(const Session& session, const SampleTimeStep& step, XrTime sampled) {
  switch (step.policy) {
    case SampleTime::zero:
      return 0;
    case SampleTime::future:
      return now() + nanoseconds(1.0);
    case SampleTime::stuck:
      return session.frames.front().sample_time;
    case SampleTime::truthful:
      break;
  }
  return sampled - nanoseconds(step.delay_ms * 1e-3);
}

Located locate_gaze(const Session& session, XrTime time) {
  if (session.frames.empty()) {
    return {Pose(), false, false};
  }
  const Script& script = runtime().script;
  const Frame& frame = frame_of_sample(session, time);
  const SampleTimeStep step = sample_time_at(script, frame.time_s);
  const double seen_s = frame.time_s - step.delay_ms * 1e-3;
  const std::optional<GazeGap> gap = gaze_gap_at(script, seen_s);
  if (gap && *gap != GazeGap::blink) {
    return {Pose(), false, false};
  }
  const Located head = locate_head(session, time);
  return {head.pose * gaze_at(script, seen_s), true, head.is_tracked && !gap,
          told_sample_time(session, step, frame.sample_time)};
}

/// Hands are held still in front of the body, as the script does not move them.
Located locate_hand(const std::string& source) {
  const bool is_left = source.rfind("/user/hand/left/", 0) == 0;
  return {turned({}, {is_left ? -0.2 : 0.2, -0.4, -0.3})};
}

Located locate_action(const Session& session, const Space& space, XrTime time) {
  const std::vector<std::string> sources = bound_sources(*space.action, space.subaction);
  if (sources.empty() || !is_synchronised(session.synchronised, *space.action, space.subaction)) {
    return {Pose(), false, false};
  }
  return sources.front() == gaze_source ? locate_gaze(session, time) : locate_hand(sources.front());
}

Located locate_reference(const Session& session, XrReferenceSpaceType type, XrTime time) {
  switch (type) {
    case XR_REFERENCE_SPACE_TYPE_VIEW:
      return locate_head(session, time);
    case XR_REFERENCE_SPACE_TYPE_STAGE:
      return {turned({}, {0.0, -runtime().script.eye_height_m, 0.0})};
    default:
      return {local_origin(session, time)};
  }
}

XrSpaceLocationFlags flags_of(const Located& space, const Located& base) {
  XrSpaceLocationFlags flags = 0;
  if (space.is_valid && base.is_valid) {
    flags |= XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
    if (space.is_tracked && base.is_tracked) {
      flags |= XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
    }
  }
  return flags;
}

const std::vector<XrReferenceSpaceType>& reference_spaces() {
  static const std::vector<XrReferenceSpaceType> all = {
      XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL, XR_REFERENCE_SPACE_TYPE_STAGE};
  return all;
}

void require_reference(XrReferenceSpaceType type) {
  const std::vector<XrReferenceSpaceType>& all = reference_spaces();
  require(std::find(all.begin(), all.end(), type) != all.end(),
          XR_ERROR_REFERENCE_SPACE_UNSUPPORTED, "there is no such reference space");
}

void require_pose(const XrPosef& pose) {
  require(is_valid(pose), XR_ERROR_POSE_INVALID,
          "the pose is not finite, or its quaternion's length is not 1");
}

}  // namespace

Located locate(const Session& session, const Space& space, XrTime time) {
  Located located = space.action ? locate_action(session, space, time)
                                 : locate_reference(session, space.reference, time);
  located.pose = located.pose * space.offset;
  return located;
}

XrResult enumerate_reference_spaces(XrSession session, std::uint32_t capacity, std::uint32_t* count,
                                    XrReferenceSpaceType* spaces) {
  session_of(session);
  give_items(reference_spaces(), capacity, count, spaces);
  return XR_SUCCESS;
}

XrResult create_reference_space(XrSession session, const XrReferenceSpaceCreateInfo* create_info,
                                XrSpace* space) {
  session_of(session);
  const XrReferenceSpaceCreateInfo& info =
      checked(create_info, XR_TYPE_REFERENCE_SPACE_CREATE_INFO, "the information for the space");
  XrSpace& place = place_for(space, "the place for the space");
  require_reference(info.referenceSpaceType);
  require_pose(info.poseInReferenceSpace);
  auto made = std::make_shared<Space>();
  made->reference = info.referenceSpaceType;
  made->offset = pose_of(info.poseInReferenceSpace);
  place = runtime().spaces.add(std::move(made));
  return XR_SUCCESS;
}

XrResult get_reference_space_bounds_rect(XrSession session, XrReferenceSpaceType type,
                                         XrExtent2Df* bounds) {
  session_of(session);
  require_reference(type);
  place_for(bounds, "the place for the bounds") = {0.0F, 0.0F};
  return XR_SPACE_BOUNDS_UNAVAILABLE;
}

XrResult create_action_space(XrSession session, const XrActionSpaceCreateInfo* create_info,
                             XrSpace* space) {
  session_of(session);
  const XrActionSpaceCreateInfo& info =
      checked(create_info, XR_TYPE_ACTION_SPACE_CREATE_INFO, "the information for the space");
  XrSpace& place = place_for(space, "the place for the space");
  auto made = std::make_shared<Space>();
  made->action = runtime().actions.at(info.action);
  require(made->action->type == XR_ACTION_TYPE_POSE_INPUT, XR_ERROR_ACTION_TYPE_MISMATCH,
          "the action is not of poses");
  made->subaction = subaction_of(*made->action, info.subactionPath);
  require_pose(info.poseInActionSpace);
  made->offset = pose_of(info.poseInActionSpace);
  place = runtime().spaces.add(std::move(made));
  return XR_SUCCESS;
}

XrResult locate_space(XrSpace space, XrSpace base_space, XrTime time, XrSpaceLocation* location) {
  const Session& session = current_session();
  const std::shared_ptr<Space> wanted = runtime().spaces.at(space);
  const std::shared_ptr<Space> base = runtime().spaces.at(base_space);
  XrSpaceLocation& place = checked(location, XR_TYPE_SPACE_LOCATION, "the place for the location");
  require_time(session, time);
  const Located there = locate(session, *wanted, time);
  const Located here = locate(session, *base, time);
  place.locationFlags = flags_of(there, here);
  place.pose = for_application(place.locationFlags == 0 ? Pose() : inverse(here.pose) * there.pose);
  if (auto* const velocity = chained_result<XrSpaceVelocity>(place.next, XR_TYPE_SPACE_VELOCITY)) {
    velocity->velocityFlags = 0;
  }
  if (auto* const sample =
          chained_result<XrEyeGazeSampleTimeEXT>(place.next, XR_TYPE_EYE_GAZE_SAMPLE_TIME_EXT)) {
    sample->time = there.sample_time;
  }
  return XR_SUCCESS;
}

XrResult destroy_space(XrSpace space) {
  runtime().spaces.remove(space);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
