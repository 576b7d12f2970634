// A headset that is there: what is asked of it and drawn for it, frame by frame, and what an
// experimenter sees of it in the window.
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

/// A few times a second, so that it costs the headset next to nothing. Needs the window's context
/// in all that it does.
class HeadsetMirror {
 public:
  static constexpr Nanoseconds interval = std::chrono::milliseconds(40);

  /// window must outlive it; its swaps wait for nothing.
  explicit HeadsetMirror(Window& window) : window_(&window) {}

  /// A frame of the headset begins: whether the window's turn has come by `now`.
  void begin_frame(Nanoseconds now);
  /// Copies `view` from the framebuffer that is bound, if it has.
  void copy(const ShownView& view);
  /// The frame was handed to the headset: shows what was copied, if anything was, and over it the
  /// gaze (unit length, world), if it is known, and panels.
  void show(const std::optional<Vec3>& gaze, std::span<const TextPanel> panels,
            FramePainter& painter);

 private:
  Window* window_;
  Nanoseconds next_{0};
  bool is_due_ = false;
  IVec2 window_px_{0};
  std::optional<ShownView> copied_;  ///< and the part of the window that it fills
};

/// The largest part in the middle of a window that has the shape of `picture`; sizes in pixels.
WindowPart largest_part(const IVec2& window, const IVec2& picture);

/// One thread uses it, whose OpenGL context must be the one that it was made with.
class HeadsetConnection {
 public:
  /// How far away pages stand: where eyes rest that look at them for long.
  static constexpr float page_distance_m = 1.5F;

  /// Draws with the OpenGL context that is current. Throws Error, with what to do, if there is no
  /// headset.
  HeadsetConnection();

  XrSessionOwner& session() { return session_; }

  /// As the session's.
  void follow_events(std::vector<HeadsetChange>& changes);

  /// Asks for the keys, the head and the gaze `now`, of which `motion` and `keys` are told.
  /// planned: the next frame.
  void ask(Nanoseconds now, const XrPlannedFrame& planned, HeadsetMotion& motion,
           std::vector<WindowEvent>& keys);
  /// What is known of the headset; empty before it knows where its eyes are. asked: when the
  /// runtime asked for the frame.
  std::optional<HeadsetFacts> facts(const XrPlannedFrame& planned, Nanoseconds asked) const;

  /// Shows what the eyes see of a frame, of which the film is drawn as it is now, as the head is
  /// turned when the planned frame is to be seen. A picture that it asks for is given once. mirror:
  /// gets what the left eye sees.
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
