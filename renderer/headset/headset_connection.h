// A connected headset: polled and drawn frame by frame, with a mirror for the experimenter in the
// window.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/headset/eye_views.h"
#include "renderer/headset/headset_facts.h"
#include "renderer/headset/headset_inputs.h"
#include "renderer/headset/headset_motion.h"
#include "renderer/headset/xr_session.h"
#include "renderer/window/drawing/frame_painter.h"
#include "renderer/window/window.h"

namespace foveola {

/// The window's copy of the headset, updated a few times a second to cost it next to nothing. Needs
/// the window's context throughout.
class HeadsetMirror {
 public:
  static constexpr Nanoseconds interval = std::chrono::milliseconds(40);

  /// window must outlive it; its swaps do not wait.
  explicit HeadsetMirror(Window& window) : window_(&window) {}

  /// Begins a frame of the headset: checks whether the window is due at `now`.
  void begin_frame(Nanoseconds now);
  /// Copies `view` from the bound framebuffer, if due.
  void copy(const ShownView& view);
  /// To be called once the frame was handed to the headset. Shows the copy, if any, and over it the
  /// gaze (unit length, world), if known, and panels.
  void show(const std::optional<Vec3>& gaze, std::span<const TextPanel> panels,
            FramePainter& painter);

 private:
  Window* window_;
  Nanoseconds next_{0};
  bool is_due_ = false;
  IVec2 window_px_{0};
  std::optional<ShownView> copied_;  ///< and its part of the window
};

/// The largest centred part of a window with the shape of `picture`; sizes in pixels.
WindowPart largest_part(const IVec2& window, const IVec2& picture);

/// For one thread, whose OpenGL context must be the one that it was created with.
class HeadsetConnection {
 public:
  /// Distance of pages, comfortable for eyes over long times.
  static constexpr float page_distance_m = 1.5F;

  /// Draws with the current OpenGL context. Throws Error with a remedy if there is no headset.
  HeadsetConnection();

  XrSessionOwner& session() { return session_; }

  /// As XrSessionOwner::follow_events.
  void follow_events(std::vector<HeadsetChange>& changes);

  /// Polls keys, head and gaze at `now` into `motion` and `keys`. planned: the next frame.
  void ask(Nanoseconds now, const XrPlannedFrame& planned, HeadsetMotion& motion,
           std::vector<WindowEvent>& keys);
  /// The headset's facts; nullopt before the eyes' places are known. asked: when the runtime asked
  /// for the frame.
  std::optional<HeadsetFacts> facts(const XrPlannedFrame& planned, Nanoseconds asked) const;

  /// Shows the eyes' views of a frame, with the film's current state and the head's orientation at
  /// the planned frame's display. A requested picture is delivered once. mirror: receives the left
  /// eye's view.
  void show(const XrPlannedFrame& planned, ShownFrame& shown, const Quat& world_from_room,
            FramePainter& painter, HeadsetMirror& mirror);

 private:
  void draw_film(std::size_t eye, const XrFovf& fov, const ShownView& view, const ShownFrame& shown,
                 FramePainter& painter) const;
  void draw(std::size_t eye, const XrFovf& fov, const ShownView& view, ShownFrame& shown,
            FramePainter& painter, HeadsetMirror& mirror);

  XrInstanceOwner instance_;
  XrSessionOwner session_;
  HeadsetInputs inputs_;
  std::array<EyeImages, 2> images_;
  std::array<HiddenArea, 2> hidden_;
  GazeTimes gaze_times_;
};

}  // namespace foveola
