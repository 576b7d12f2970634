#include <chrono>
#include <cmath>
#include <thread>

#include <fmt/format.h>

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

XrDuration period() { return std::llround(1e9 / runtime().script.refresh_hz); }

/// When the next frame starts: a period after the last one, or as many as have gone by.
XrTime next_wake_up(const Session& session) {
  const XrTime present = now();
  if (session.last_wake_up == 0 || !runtime().script.is_real_time) {
    return present;
  }
  const XrTime next = session.last_wake_up + period();
  const XrDuration late = std::max<XrDuration>(present - next, 0);
  return next + (late + period() - 1) / period() * period();
}

Frame next_frame(Session& session) {
  Frame frame;
  const std::filesystem::path& start = runtime().script.starts_with;
  if (session.was_focused && (start.empty() || std::filesystem::exists(start))) {
    frame.number = session.frames_since_focus++;
    frame.time_s = static_cast<double>(frame.number) / runtime().script.refresh_hz;
  }
  const XrTime last = session.frames.empty() ? 0 : session.frames.back().display_time;
  frame.display_time = std::max(session.last_wake_up + period(), last + 1);
  frame.sample_time = now();
  return frame;
}

XrResult result_of_frame(const Session& session) {
  return session.is_loss_pending ? XR_SESSION_LOSS_PENDING : XR_SUCCESS;
}

bool is_same_fov(const XrFovf& a, const XrFovf& b) {
  constexpr float tolerance_rad = 1e-4F;
  return std::abs(a.angleLeft - b.angleLeft) <= tolerance_rad &&
         std::abs(a.angleRight - b.angleRight) <= tolerance_rad &&
         std::abs(a.angleUp - b.angleUp) <= tolerance_rad &&
         std::abs(a.angleDown - b.angleDown) <= tolerance_rad;
}

/// Refuses views that a headset would show in the wrong place.
void check_layer(const Session& session, const XrCompositionLayerProjection& layer) {
  const XrTime display_time = session.frames.back().display_time;
  require(layer.type == XR_TYPE_COMPOSITION_LAYER_PROJECTION && layer.viewCount == 2,
          XR_ERROR_LAYER_INVALID, "the layer is not a projection of two views");
  require(session.times_of_views.contains(display_time), XR_ERROR_LAYER_INVALID,
          "the views were not located for this frame");
  const std::vector<XrView> located =
      views_at(session, object_of<Space>(layer.space), display_time);
  for (std::size_t eye = 0; eye < located.size(); ++eye) {
    check_image(layer.views[eye].subImage);
    require(is_same(layer.views[eye].pose, located[eye].pose), XR_ERROR_LAYER_INVALID,
            fmt::format("view {} has another pose than was located for this frame", eye));
    require(is_same_fov(layer.views[eye].fov, located[eye].fov), XR_ERROR_LAYER_INVALID,
            fmt::format("view {} has another field of view than its eye", eye));
  }
}

void record(const Session& session, const XrCompositionLayerProjection* layer) {
  const std::int64_t frame = session.frames.back().number;
  nlohmann::json orientations = nlohmann::json::array();
  for (std::uint32_t view = 0; layer != nullptr && view < layer->viewCount; ++view) {
    const XrQuaternionf& q = layer->views[view].pose.orientation;
    orientations.push_back({q.x, q.y, q.z, q.w});
    if (runtime().script.saves_pictures) {
      save_image(layer->views[view].subImage,
                 runtime().folder / fmt::format("{}-{}.ppm", frame, view));
    }
  }
  write_log({{"kind", "frame"}, {"frame", frame}, {"orientations", orientations}});
}

}  // namespace

XrResult WaitFrame(XrSession session, const XrFrameWaitInfo* /*info*/, XrFrameState* state) {
  auto& waiting = object_of<Session>(session);
  require(waiting.is_running, XR_ERROR_SESSION_NOT_RUNNING, "the session does not run");
  require(!waiting.is_waited, XR_ERROR_CALL_ORDER_INVALID,
          "the frame that was waited for was not begun; a headset would wait for ever");
  waiting.last_wake_up = next_wake_up(waiting);
  std::this_thread::sleep_for(std::chrono::nanoseconds(waiting.last_wake_up - now()));
  const Frame& frame = waiting.frames.emplace_back(next_frame(waiting));
  play_events(waiting, frame.time_s);
  waiting.is_waited = true;
  state->predictedDisplayTime = frame.display_time;
  state->predictedDisplayPeriod = period();
  state->shouldRender =
      waiting.state == XR_SESSION_STATE_VISIBLE || waiting.state == XR_SESSION_STATE_FOCUSED
          ? XR_TRUE
          : XR_FALSE;
  return result_of_frame(waiting);
}

XrResult BeginFrame(XrSession session, const XrFrameBeginInfo* /*info*/) {
  auto& beginning = object_of<Session>(session);
  require(beginning.is_waited && !beginning.is_begun, XR_ERROR_CALL_ORDER_INVALID,
          "no frame was waited for, or the last one was not ended");
  beginning.is_waited = false;
  beginning.is_begun = true;
  return result_of_frame(beginning);
}

XrResult EndFrame(XrSession session, const XrFrameEndInfo* info) {
  auto& ending = object_of<Session>(session);
  require(ending.is_begun, XR_ERROR_CALL_ORDER_INVALID, "no frame was begun");
  require(info->displayTime == ending.frames.back().display_time, XR_ERROR_TIME_INVALID,
          "the display time is not the frame's");
  require(info->environmentBlendMode == XR_ENVIRONMENT_BLEND_MODE_OPAQUE,
          XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED, "the headset is opaque");
  require(info->layerCount <= 1, XR_ERROR_LAYER_LIMIT_EXCEEDED, "there is one layer at most");
  const auto* const layer =
      info->layerCount == 0
          ? nullptr
          : reinterpret_cast<const XrCompositionLayerProjection*>(info->layers[0]);
  if (layer != nullptr) {
    check_layer(ending, *layer);
  }
  record(ending, layer);
  ending.is_begun = false;
  ending.times_of_views.clear();
  rise_by_one(ending);
  return result_of_frame(ending);
}

}  // namespace foveola::test::openxr
