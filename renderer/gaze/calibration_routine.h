// Targets to look at one after the other, by which a tracker is calibrated and validated.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_movements.h"
#include "renderer/gaze/gaze_quality.h"

namespace foveola {

/// Directions in the head's axes: the middle of the view and its corners (5), or the middle and a
/// grid around it (9). Across and up, they reach to four fifths of the way to the edge of the view,
/// but not beyond 20 degrees, where few shifts of gaze go without the head (Stahl 1999). points: 5
/// or 9. Fields of view in (0, 180).
std::vector<Vec3> calibration_targets(int points, double horizontal_fov_deg,
                                      double vertical_fov_deg);

/// All assumed; a saccade to a target begins after 0.2 s and is over within 0.1 s.
struct CalibrationTiming {
  Nanoseconds settle = std::chrono::milliseconds(700);  ///< until a target's samples count
  Nanoseconds collect = std::chrono::seconds(1);  ///< how long the gaze must be known for then
  /// A longer interval between valid samples does not count.
  Nanoseconds longest_interval = EyeMovementSettings{}.longest_interval;
  Nanoseconds give_up = std::chrono::seconds(4);  ///< after a target's appearance; > settle
};

/// Shows a target until its samples are collected or given up, then the next. It depends
/// on its arguments alone: whoever drives it keeps the clock, shows the target, and polls the
/// tracker.
class CalibrationRoutine {
 public:
  /// targets: at least one. The first appears at `start`.
  CalibrationRoutine(std::vector<Vec3> targets, const CalibrationTiming& timing, Nanoseconds start);

  /// Takes what has arrived by `now`. If a target is done with, the next one appears at `now`.
  void update(Nanoseconds now, std::span<const GazeSample> arrived);

  /// What is to be looked at, in the head's axes; empty if all is done.
  std::optional<Vec3> target() const;
  /// The targets that are done with.
  const std::vector<WatchedTarget>& watched() const { return watched_; }

 private:
  /// Returns whether that was enough.
  bool collect(const GazeSample& sample);
  void show_next(Nanoseconds now);

  std::vector<Vec3> targets_;
  CalibrationTiming timing_;
  std::vector<WatchedTarget> watched_;
  WatchedTarget watching_;
  Nanoseconds collected_{0};
  std::optional<Nanoseconds> last_valid_;
};

}  // namespace foveola
