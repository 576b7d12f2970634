// A check of the eye tracker in the preview's window: dots to look at, one after the other.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/gaze/calibration.h"
#include "renderer/window/panel_layout.h"
#include "renderer/window/view_geometry.h"
#include "renderer/window/view_overlays.h"

namespace foveola {

/// Goes on from begin() until every dot was looked at or given up, or until it is ended.
class TrackerCheck {
 public:
  /// The dots are spread over the view that `geometry` has now. One that goes on begins anew.
  void begin(const ViewGeometry& geometry, const CalibrationTiming& timing, Nanoseconds now);
  void end() { routine_.reset(); }
  bool goes_on() const { return routine_.has_value(); }

  /// Takes what arrived until `now`. Returns what was seen of each dot when the last one is done
  /// with, and ends then.
  std::optional<std::vector<WatchedTarget>> update(Nanoseconds now,
                                                   std::span<const GazeSample> arrived);

  /// The dot in the view of a head of this orientation, on grey; while it goes on.
  ViewOverlays overlays(const Quat& head) const;
  /// What to do; while it goes on.
  TextPanel panel() const;

 private:
  std::optional<CalibrationRoutine> routine_;
};

}  // namespace foveola
