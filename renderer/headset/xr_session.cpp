#include "renderer/headset/xr_session.h"

#include "renderer/headset/eye_views.h"
#include "renderer/headset/glx_session.h"

namespace foveola {
namespace {

constexpr XrSpaceLocationFlags tracked =
    XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;

bool has_focus(XrSessionState state) { return state == XR_SESSION_STATE_FOCUSED; }

}  // namespace

XrSessionOwner::XrSessionOwner(const XrInstanceOwner& instance)
    : instance_(&instance), session_(make_glx_session(instance)) {
  try {
    make_spaces();
  } catch (...) {
    instance.xr().DestroySession(session_);
    throw;
  }
}

XrSessionOwner::~XrSessionOwner() { instance_->xr().DestroySession(session_); }

void XrSessionOwner::make_spaces() {
  room_ = make_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  head_ = make_space(XR_REFERENCE_SPACE_TYPE_VIEW);
}

XrSpace XrSessionOwner::make_space(XrReferenceSpaceType type) const {
  XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO};
  info.referenceSpaceType = type;
  info.poseInReferenceSpace = same_pose;
  XrSpace space = XR_NULL_HANDLE;
  instance_->require(instance_->xr().CreateReferenceSpace(session_, &info, &space),
                     "xrCreateReferenceSpace");
  return space;
}

void XrSessionOwner::follow_events(std::vector<HeadsetChange>& changes) {
  for (XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
       instance_->xr().PollEvent(instance_->handle(), &event) == XR_SUCCESS;
       event = {XR_TYPE_EVENT_DATA_BUFFER}) {
    if (event.type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) {
      follow_state(reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state, changes);
    } else if (event.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING) {
      throw HeadsetLost();
    } else if (event.type == XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING) {
      const auto& change = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event);
      if (change.referenceSpaceType == XR_REFERENCE_SPACE_TYPE_LOCAL) {
        changes.push_back(HeadsetChange::recentred);
      }
    } else if (event.type == XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR) {
      has_mask_changed_ = true;
    }
#ifdef XR_EXT_user_presence
    if (event.type == XR_TYPE_EVENT_DATA_USER_PRESENCE_CHANGED_EXT) {
      const auto& change = reinterpret_cast<const XrEventDataUserPresenceChangedEXT&>(event);
      follow_presence(change.isUserPresent != XR_FALSE, changes);
    }
#endif
  }
}

/// A runtime reports it initially, too.
void XrSessionOwner::follow_presence(bool is_worn, std::vector<HeadsetChange>& changes) {
  if (is_worn != std::exchange(is_worn_, is_worn)) {
    changes.push_back(is_worn ? HeadsetChange::put_on : HeadsetChange::taken_off);
  }
}

void XrSessionOwner::follow_state(XrSessionState state, std::vector<HeadsetChange>& changes) {
  if (has_focus(state) != has_focus(state_)) {
    changes.push_back(has_focus(state) ? HeadsetChange::got_focus : HeadsetChange::lost_focus);
  }
  state_ = state;
  switch (state) {
    case XR_SESSION_STATE_READY:
      begin();
      break;
    case XR_SESSION_STATE_STOPPING:
      is_running_ = false;
      instance_->require(instance_->xr().EndSession(session_), "xrEndSession");
      break;
    case XR_SESSION_STATE_LOSS_PENDING:
      throw HeadsetLost();
    default:
      break;
  }
}

void XrSessionOwner::begin() {
  XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO};
  info.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
  instance_->require(instance_->xr().BeginSession(session_, &info), "xrBeginSession");
  is_running_ = true;
}

XrPlannedFrame XrSessionOwner::wait_for_frame() const {
  const XrFrameWaitInfo info{XR_TYPE_FRAME_WAIT_INFO};
  XrFrameState state{XR_TYPE_FRAME_STATE};
  instance_->require(instance_->xr().WaitFrame(session_, &info, &state), "xrWaitFrame");
  return {.display_time = state.predictedDisplayTime,
          .interval = Nanoseconds(state.predictedDisplayPeriod),
          .is_drawn = state.shouldRender != XR_FALSE};
}

void XrSessionOwner::begin_frame() const {
  const XrFrameBeginInfo info{XR_TYPE_FRAME_BEGIN_INFO};
  instance_->require(instance_->xr().BeginFrame(session_, &info), "xrBeginFrame");
}

void XrSessionOwner::end_frame(const XrPlannedFrame& frame,
                               std::span<const XrCompositionLayerProjectionView> views) const {
  XrCompositionLayerProjection projection{XR_TYPE_COMPOSITION_LAYER_PROJECTION};
  projection.space = room_;
  projection.viewCount = static_cast<std::uint32_t>(views.size());
  projection.views = views.data();
  const auto* const layer = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&projection);
  XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO};
  end.displayTime = frame.display_time;
  end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  end.layerCount = views.empty() ? 0 : 1;
  end.layers = &layer;
  instance_->require(instance_->xr().EndFrame(session_, &end), "xrEndFrame");
}

std::optional<Quat> XrSessionOwner::head_at(XrTime time) const {
  XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
  const XrResult located = instance_->xr().LocateSpace(head_, room_, time, &location);
  if (located == XR_ERROR_TIME_INVALID) {
    return std::nullopt;
  }
  instance_->require(located, "xrLocateSpace");
  const bool is_known = (location.locationFlags & XR_SPACE_LOCATION_ORIENTATION_VALID_BIT) != 0;
  return is_known ? std::optional(orientation_of(location.pose)) : std::nullopt;
}

std::optional<std::array<XrView, 2>> XrSessionOwner::eyes_at(XrTime time) const {
  XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO};
  info.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
  info.displayTime = time;
  info.space = room_;
  XrViewState state{XR_TYPE_VIEW_STATE};
  std::uint32_t count = 0;
  std::array<XrView, 2> views;
  views.fill({XR_TYPE_VIEW});
  instance_->require(instance_->xr().LocateViews(session_, &info, &state, 2, &count, views.data()),
                     "xrLocateViews");
  const bool is_known = (state.viewStateFlags & XR_VIEW_STATE_ORIENTATION_VALID_BIT) != 0;
  return is_known ? std::optional(views) : std::nullopt;
}

ToldGaze XrSessionOwner::gaze_at(Nanoseconds now, XrSpace gaze) const {
  XrEyeGazeSampleTimeEXT sampled{XR_TYPE_EYE_GAZE_SAMPLE_TIME_EXT};
  XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
  location.next = &sampled;
  instance_->require(instance_->xr().LocateSpace(gaze, head_, instance_->xr_time(now), &location),
                     "xrLocateSpace");
  ToldGaze told{.asked = now};
  if (sampled.time > 0) {
    told.sampled = instance_->steady_time(sampled.time);
  }
  told.is_valid = (location.locationFlags & tracked) == tracked;
  if (told.is_valid) {
    told.direction = glm::normalize(orientation_of(location.pose) * Vec3(0.0F, 0.0F, -1.0F));
  }
  return told;
}

}  // namespace foveola
