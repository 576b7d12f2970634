// The display of live pictures, a window or a headset.
#pragma once

#include <memory>
#include <optional>

#include "renderer/gaze/gaze_source.h"
#include "renderer/headset/headset_presenter.h"
#include "renderer/window/window.h"

namespace foveola {

class LiveDisplay {
 public:
  /// Opens the display of `profile`: `window`, of `framebuffer` pixels, or a headset, whose mirror
  /// the window then is. Window, events and clock must outlive it. Throws Error if it is not there.
  LiveDisplay(Window& window, WindowEvents& events, const DisplayProfile& profile,
              const IVec2& framebuffer, const Clock& clock);

  Presenter& presenter() { return *presenter_; }
  /// Null for a window.
  HeadsetPresenter* headset() { return headset_; }
  /// Including the properties that a headset reports.
  const DisplayProfile& profile() const { return profile_; }
  /// As Window::place.
  std::optional<WindowPlace> place() const { return window_->place(); }
  /// The size of the picture, in pixels: of the window, or for one eye.
  const IVec2& picture_px() const { return picture_px_; }
  /// The window's initial size, in pixels.
  const IVec2& window_px() const { return window_px_; }

 private:
  const Window* window_;
  std::unique_ptr<Presenter> presenter_;
  HeadsetPresenter* headset_ = nullptr;
  DisplayProfile profile_;
  IVec2 picture_px_;
  IVec2 window_px_;
};

/// The tracker of the person at `display`, which must outlive it. Throws Error as
/// open_window_eye_tracker, if it is a headset's and there is no headset, and if it is for a
/// monitor and it is unknown which one.
WindowEyeTracker open_eye_tracker_of(LiveDisplay& display, const TrackerProfile& profile,
                                     const Clock& clock);

}  // namespace foveola
