#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include <fmt/format.h>

#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/layers.h"
#include "tests/openxr/runtime/session_states.h"
#include "tests/openxr/runtime/times.h"

namespace foveola::test::openxr {
namespace {

/// Another thread may be about to begin the last frame. If none is, a runtime would wait for ever,
/// which a test should not.
constexpr std::chrono::seconds patience_with_begin{2};

void wait_for_begin(XrSession handle) {
  const auto is_over = [&] { return !running_session_of(handle).waited.has_value(); };
  if (!runtime().frame_begun.wait_for(runtime().mutex, patience_with_begin, is_over)) {
    throw Refusal(XR_ERROR_CALL_ORDER_INVALID,
                  "the frame that was waited for was not begun; a headset would wait for ever");
  }
}

XrDuration period() { return nanoseconds(1.0 / runtime().script.refresh_hz); }

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

void sleep_until(XrTime time) {
  runtime().mutex.unlock();
  std::this_thread::sleep_for(std::chrono::nanoseconds(time - now()));
  runtime().mutex.lock();
}

bool has_script_started(const Session& session) {
  const std::filesystem::path& file = runtime().script.starts_with;
  return session.was_focused && (file.empty() || std::filesystem::exists(file));
}

Frame next_frame(Session& session, XrTime wake_up) {
  Frame frame;
  if (has_script_started(session)) {
    frame.number = session.frames_since_focus++;
    frame.time_s = static_cast<double>(frame.number) / runtime().script.refresh_hz;
  }
  const XrTime last = session.frames.empty() ? 0 : session.frames.back().display_time;
  frame.display_time = std::max(wake_up + period(), last + 1);
  frame.sample_time = now();
  return frame;
}

bool is_to_be_rendered(const Session& session, const Frame& frame) {
  const bool is_visible =
      session.state == XR_SESSION_STATE_VISIBLE || session.state == XR_SESSION_STATE_FOCUSED;
  return is_visible && !is_in_any(runtime().script.no_render, frame.time_s);
}

void check_end(const Session& session, const XrFrameEndInfo& info) {
  require(session.begun.has_value(), XR_ERROR_CALL_ORDER_INVALID, "no frame was begun");
  require(info.displayTime > 0, XR_ERROR_TIME_INVALID, "times are positive");
  if (info.displayTime != session.begun->display_time) {
    throw Refusal(XR_ERROR_TIME_INVALID,
                  fmt::format("the display time is {} ns from the frame's",
                              info.displayTime - session.begun->display_time));
  }
  require(info.environmentBlendMode == XR_ENVIRONMENT_BLEND_MODE_OPAQUE,
          XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED, "the headset is opaque");
  require(info.layerCount <= XR_MIN_COMPOSITION_LAYERS_SUPPORTED, XR_ERROR_LAYER_LIMIT_EXCEEDED,
          "there are more layers than the system supports");
  require(info.layerCount == 0 || info.layers != nullptr, XR_ERROR_LAYER_INVALID,
          "the layers are a null pointer");
  for (std::uint32_t i = 0; i < info.layerCount; ++i) {
    check_layer(session, *session.begun, info.layers[i]);
  }
}

void record(const Session& session, const XrFrameEndInfo& info) {
  const Frame& frame = *session.begun;
  const std::vector<std::int64_t>& saved = runtime().script.save_frames;
  const bool is_saved = std::find(saved.begin(), saved.end(), frame.number) != saved.end();
  nlohmann::json layers = nlohmann::json::array();
  for (std::uint32_t i = 0; i < info.layerCount; ++i) {
    layers.push_back(description_of(*info.layers[i]));
    if (is_saved) {
      save_pictures(session, frame, *info.layers[i]);
    }
  }
  runtime().log.write({{"kind", "frame"},
                       {"frame", frame.number},
                       {"time_s", frame.time_s},
                       {"predicted_display_time", frame.display_time},
                       {"display_time", info.displayTime},
                       {"should_render", frame.should_render},
                       {"layers", layers}});
}

}  // namespace

XrResult wait_frame(XrSession session, const XrFrameWaitInfo* wait_info, XrFrameState* state) {
  check_if_given(wait_info, XR_TYPE_FRAME_WAIT_INFO, "how to wait");
  XrFrameState& place = checked(state, XR_TYPE_FRAME_STATE, "the place for the frame's state");
  wait_for_begin(session);
  const XrTime wake_up = next_wake_up(running_session_of(session));
  sleep_until(wake_up);
  // Another thread may have ended the session meanwhile.
  Session& waiting = running_session_of(session);
  waiting.last_wake_up = wake_up;
  waiting.frames.push_back(next_frame(waiting, wake_up));
  play_events(waiting, waiting.frames.back().time_s);
  require(!waiting.is_lost, XR_ERROR_SESSION_LOST, "the session is lost");
  Frame& frame = waiting.frames.back();
  frame.should_render = is_to_be_rendered(waiting, frame);
  waiting.waited = frame;
  place.predictedDisplayTime = frame.display_time;
  place.predictedDisplayPeriod = period();
  place.shouldRender = frame.should_render ? XR_TRUE : XR_FALSE;
  return XR_SUCCESS;
}

XrResult begin_frame(XrSession session, const XrFrameBeginInfo* begin_info) {
  Session& beginning = running_session_of(session);
  check_if_given(begin_info, XR_TYPE_FRAME_BEGIN_INFO, "how to begin");
  require(beginning.waited.has_value(), XR_ERROR_CALL_ORDER_INVALID,
          "no frame was waited for since the last one was begun");
  const std::optional<Frame> discarded = beginning.begun;
  beginning.begun = std::exchange(beginning.waited, std::nullopt);
  runtime().frame_begun.notify_all();
  if (discarded) {
    runtime().log.write({{"kind", "discarded"}, {"frame", discarded->number}});
    return XR_FRAME_DISCARDED;
  }
  return XR_SUCCESS;
}

XrResult end_frame(XrSession session, const XrFrameEndInfo* end_info) {
  Session& ending = running_session_of(session);
  const XrFrameEndInfo& info =
      checked(end_info, XR_TYPE_FRAME_END_INFO, "the information for the frame");
  check_end(ending, info);
  record(ending, info);
  const XrTime shown = ending.begun->display_time;
  ending.begun.reset();
  ending.times_of_views.erase(ending.times_of_views.begin(),
                              ending.times_of_views.upper_bound(shown));
  rise_by_one(ending);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
