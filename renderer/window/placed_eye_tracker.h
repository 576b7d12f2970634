// The gaze in a window that is a part of the monitor which a tracker watches.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/profiles.h"
#include "renderer/window/window.h"

namespace foveola {

/// A tracker tells which place of a monitor the eye looks at, as an angle at its middle by a
/// profile. This turns it into the angle at the window's middle, by the pixels that the monitor
/// really has.
class PlacedEyeTracker final : public EyeTracker {
 public:
  /// display: a monitor's profile. place: where the window is, asked at each poll; what it refers
  /// to must outlive the tracker.
  PlacedEyeTracker(std::unique_ptr<EyeTracker> source, const DisplayProfile& display,
                   std::function<std::optional<WindowPlace>()> place);

  /// While it is not known where the window is, samples are invalid.
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override;

 private:
  std::unique_ptr<EyeTracker> source_;
  DVec2 display_px_;
  DVec2 pixel_;  ///< a pixel's sides, in viewing distances
  std::function<std::optional<WindowPlace>()> place_;
};

}  // namespace foveola
