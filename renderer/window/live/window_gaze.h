// Gaze in a window: on a part of the observed monitor, or in a widened view; and a check of the eye
// tracker by successive targets.
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

/// Runs from begin() until every target was looked at or timed out, or until end().
class TrackerCheck {
 public:
  /// Spreads the targets over the current view of `geometry`. Restarts a running check.
  void begin(const ViewGeometry& geometry, const CalibrationTiming& timing, Nanoseconds now);
  void end() { routine_.reset(); }
  bool is_running() const { return routine_.has_value(); }

  /// Adds the samples that arrived until `now`. After the last target, returns all targets' samples
  /// and ends.
  std::optional<std::vector<WatchedTarget>> update(Nanoseconds now,
                                                   std::span<const GazeSample> arrived);

  /// The current target in the view of a head of this orientation, on grey. Only while it runs.
  ViewOverlays overlays(const Quat& head) const;
  /// Instructions. Only while it runs.
  TextPanel panel() const;

 private:
  std::optional<CalibrationRoutine> routine_;
};

/// Converts gaze in a widened view. A tracker measures the gazed place of a screen as an angle from
/// its centre; this gives the angle in a view with other angles.
class WidenedEyeTracker final : public EyeTracker {
 public:
  /// source: must outlive it.
  explicit WidenedEyeTracker(EyeTracker& source) : source_(&source) {}

  /// Scales the tangents of angles from straight ahead by `factor` (> 0), from the next poll. At 1
  /// samples stay bit-identical.
  void widen(double factor) { factor_ = factor; }

  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override { return source_->status(); }

 private:
  EyeTracker* source_;
  double factor_ = 1.0;
};

/// Converts gaze on a monitor to gaze in a window on it. A tracker measures the gazed place as an
/// angle at the monitor's centre by a profile; this gives the angle at the window's centre, by the
/// monitor's actual pixels.
class PlacedEyeTracker final : public EyeTracker {
 public:
  /// display: a monitor's profile. place: returns the window's place at each poll; objects that
  /// it refers to must outlive the tracker.
  PlacedEyeTracker(std::unique_ptr<EyeTracker> source, const DisplayProfile& display,
                   std::function<std::optional<WindowPlace>()> place);

  /// Samples are invalid while the window's place is unknown.
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override;

 private:
  std::unique_ptr<EyeTracker> source_;
  DVec2 display_px_;
  DVec2 pixel_;  ///< a pixel's sides, in viewing distances
  std::function<std::optional<WindowPlace>()> place_;
};

}  // namespace foveola
