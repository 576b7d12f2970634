#include "renderer/headset/live_display.h"

#include <utility>

#include "renderer/base/error.h"
#include "renderer/headset/headset_facts.h"
#include "renderer/window/drawing/presenter.h"
#include "renderer/window/live/window_gaze.h"

namespace foveola {

LiveDisplay::LiveDisplay(Window& window, WindowEvents& events, const DisplayProfile& profile,
                         const IVec2& framebuffer, const Clock& clock)
    : window_(&window), profile_(profile), picture_px_(framebuffer), window_px_(framebuffer) {
  if (profile.kind != DisplayKind::openxr) {
    presenter_ = std::make_unique<WindowPresenter>(window, framebuffer, clock);
    return;
  }
  auto headset = std::make_unique<HeadsetPresenter>(window, events, clock);
  headset_ = headset.get();
  presenter_ = std::move(headset);
  profile_ = told_by(headset_->facts(), profile);
  picture_px_ = {profile_.width_px, profile_.height_px};
}

WindowEyeTracker open_eye_tracker_of(LiveDisplay& display, const TrackerProfile& profile,
                                     const Clock& clock) {
  if (profile.source == TrackerSource::openxr && display.headset() != nullptr) {
    HeadsetPresenter& headset = *display.headset();
    return {.tracker =
                std::make_unique<HeadsetEyes>(headset.motion(), headset.facts().has_eye_tracker)};
  }
  WindowEyeTracker eye = open_window_eye_tracker(profile, screen_of(display.profile()), clock);
  const bool watches_monitor =
      profile.source == TrackerSource::hid || profile.source == TrackerSource::open_gaze;
  if (watches_monitor && display.profile().kind == DisplayKind::monitor) {
    if (!display.place()) {
      throw Error("tracker '" + profile.name + "'",
                  "watches one of several monitors, and the window fills none of them",
                  "fill the one that it watches, by --full-screen and --monitor");
    }
    eye.tracker = std::make_unique<PlacedEyeTracker>(std::move(eye.tracker), display.profile(),
                                                     [&display] { return display.place(); });
  }
  return eye;
}

}  // namespace foveola
