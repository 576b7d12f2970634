// What an experimenter sees of a headset: the left eye's picture in the window, with the gaze.
#pragma once

#include <optional>
#include <span>

#include "renderer/base/clock.h"
#include "renderer/window/frame_painter.h"
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

}  // namespace foveola
