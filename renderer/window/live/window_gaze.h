// Gaze in a window: on a part of the watched monitor, or in a wider or narrower view; and a check
// of the eye tracker by dots to look at, one after the other.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/gaze/calibration.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/profiles.h"
#include "renderer/window/drawing/view_geometry.h"
#include "renderer/window/drawing/view_overlays.h"
#include "renderer/window/screens/panel_layout.h"
#include "renderer/window/window.h"

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

/// A tracker sees which place of a screen the eye looks at, as an angle from its middle. Where the
/// view has other angles than the eye, this turns them into the view's.
class WidenedEyeTracker final : public EyeTracker {
 public:
  /// source: must outlive it.
  explicit WidenedEyeTracker(EyeTracker& source) : source_(&source) {}

  /// Directions are so many times farther from straight ahead on a plane before the eye, from the
  /// next poll on; > 0. At 1 samples stay as they are, to the bit.
  void widen(double times) { times_ = times; }

  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override { return source_->status(); }

 private:
  EyeTracker* source_;
  double times_ = 1.0;
};

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
