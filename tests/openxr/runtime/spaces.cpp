// Where things are, and when.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

constexpr XrDuration ahead_of_system = 3'600'000'000'000;

XrTime system_time(const timespec& time) {
  return static_cast<XrTime>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

/// Linear between the frames' display times, and beyond them.
double script_time_s(const Session& session, XrTime time) {
  const std::vector<Frame>& frames = session.frames;
  if (frames.empty()) {
    return Frame().time_s;
  }
  const auto after = std::ranges::upper_bound(frames, time, {}, &Frame::display_time);
  if (after == frames.begin()) {
    return frames.front().time_s;
  }
  const Frame& before = *std::prev(after);
  const auto since = static_cast<double>(time - before.display_time);
  if (after == frames.end()) {
    return before.time_s + since * 1e-9;
  }
  const auto whole = static_cast<double>(after->display_time - before.display_time);
  return std::lerp(before.time_s, after->time_s, since / whole);
}

/// In the room, if it is known at all.
struct Located {
  Pose pose;
  bool is_valid = true;
  bool is_tracked = true;
  XrTime sample_time = 0;  ///< of eyes, or 0
};

Located locate_head(const Session& session, XrTime time) {
  return {runtime().script.head_at(script_time_s(session, time))};
}

Located locate_gaze(const Session& session, XrTime time) {
  const Script& script = runtime().script;
  const auto after = std::ranges::upper_bound(session.frames, time, {}, &Frame::sample_time);
  if (after == session.frames.begin()) {
    return {Pose(), false, false};
  }
  const Frame& frame = *std::prev(after);
  const SampleTimeStep step = script.sample_time_at(frame.time_s);
  const double seen_s = frame.time_s - step.delay_s;
  const std::optional<GazeGap> gap = script.gaze_gap_at(seen_s);
  if (gap && !gap->is_blink) {
    return {Pose(), false, false};
  }
  const XrTime delay = std::llround(1e9 * step.delay_s);
  return {locate_head(session, time).pose * script.gaze_at(seen_s), true, !gap,
          step.is_true ? frame.sample_time - delay : 0};
}

Located locate(const Session& session, const Space& space, XrTime time) {
  if (space.action != nullptr) {
    const bool is_active = !active_sources(session, *space.action).empty();
    return is_active ? locate_gaze(session, time) : Located{Pose(), false, false};
  }
  return space.reference == XR_REFERENCE_SPACE_TYPE_VIEW
             ? locate_head(session, time)
             : Located{{rotation({.yaw_deg = session.local_yaw_deg})}};
}

XrResult add_space(XrSession session, const Space& space, const XrPosef& pose, XrSpace* made) {
  require(is_same(pose, to_xr(Pose())), XR_ERROR_POSE_INVALID, "spaces have no offset here");
  *made = handle_of<XrSpace>(object_of<Session>(session).spaces.emplace_back(space));
  return XR_SUCCESS;
}

}  // namespace

XrTime now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return system_time(time) + ahead_of_system;
}

void require_time(const Session& session, XrTime time) {
  const XrTime latest = session.frames.empty() ? now() : session.frames.back().display_time;
  const double distance_s = 1e-9 * static_cast<double>(time - latest);
  require(std::abs(distance_s) <= 60.0, XR_ERROR_TIME_INVALID,
          fmt::format("the time is {:.3f} s from the latest frame's, as another clock's would be",
                      distance_s));
}

std::vector<XrView> views_at(const Session& session, const Space& space, XrTime time) {
  const Pose head_in_space =
      inverse(locate(session, space, time).pose) * locate_head(session, time).pose;
  std::vector<XrView> views;
  for (const ScriptedEye& eye : runtime().script.eyes) {
    const Pose eye_in_head{rotation({.yaw_deg = eye.cant_deg}), eye.offset_m};
    views.push_back({XR_TYPE_VIEW, nullptr, to_xr(head_in_space * eye_in_head), eye.fov});
  }
  return views;
}

XrResult ConvertTimespecTimeToTimeKHR(XrInstance /*instance*/, const timespec* given,
                                      XrTime* time) {
  require(given->tv_sec >= 0 && given->tv_nsec >= 0 && given->tv_nsec < 1'000'000'000,
          XR_ERROR_TIME_INVALID, "the system's time is not one");
  *time = system_time(*given) + ahead_of_system;
  return XR_SUCCESS;
}

XrResult ConvertTimeToTimespecTimeKHR(XrInstance /*instance*/, XrTime time, timespec* converted) {
  require(time > ahead_of_system, XR_ERROR_TIME_INVALID,
          "the time is before the system's clock began");
  converted->tv_sec = (time - ahead_of_system) / 1'000'000'000;
  converted->tv_nsec = (time - ahead_of_system) % 1'000'000'000;
  return XR_SUCCESS;
}

XrResult CreateReferenceSpace(XrSession session, const XrReferenceSpaceCreateInfo* info,
                              XrSpace* space) {
  require(info->referenceSpaceType == XR_REFERENCE_SPACE_TYPE_VIEW ||
              info->referenceSpaceType == XR_REFERENCE_SPACE_TYPE_LOCAL,
          XR_ERROR_REFERENCE_SPACE_UNSUPPORTED, "there are VIEW and LOCAL");
  return add_space(session, {.reference = info->referenceSpaceType}, info->poseInReferenceSpace,
                   space);
}

XrResult CreateActionSpace(XrSession session, const XrActionSpaceCreateInfo* info, XrSpace* space) {
  const auto& action = object_of<const Action>(info->action);
  require(action.type == XR_ACTION_TYPE_POSE_INPUT, XR_ERROR_ACTION_TYPE_MISMATCH,
          "the action is not of poses");
  return add_space(session, {.action = &action}, info->poseInActionSpace, space);
}

XrResult LocateSpace(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* location) {
  const Session& session = *runtime().session;
  require_time(session, time);
  const Located there = locate(session, object_of<Space>(space), time);
  const Located here = locate(session, object_of<Space>(base), time);
  location->locationFlags = 0;
  if (there.is_valid && here.is_valid) {
    location->locationFlags =
        XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
    if (there.is_tracked && here.is_tracked) {
      location->locationFlags |=
          XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
    }
  }
  location->pose = to_xr(inverse(here.pose) * there.pose);
  if (auto* const sample =
          chained<XrEyeGazeSampleTimeEXT>(location->next, XR_TYPE_EYE_GAZE_SAMPLE_TIME_EXT)) {
    sample->time = there.sample_time;
  }
  return XR_SUCCESS;
}

XrResult LocateViews(XrSession session, const XrViewLocateInfo* info, XrViewState* state,
                     std::uint32_t capacity, std::uint32_t* count, XrView* views) {
  auto& located = object_of<Session>(session);
  require_time(located, info->displayTime);
  state->viewStateFlags = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT |
                          XR_VIEW_STATE_ORIENTATION_TRACKED_BIT |
                          XR_VIEW_STATE_POSITION_TRACKED_BIT;
  give_items(views_at(located, object_of<Space>(info->space), info->displayTime), capacity, count,
             views);
  located.times_of_views.insert(info->displayTime);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
