// Where the head points: one interface for every source of head pose.
#pragma once

#include <functional>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"

namespace foveola {

struct HeadPose {
  Nanoseconds time{0};
  AzimuthElevation heading;  ///< world
  double roll_rad = 0.0;     ///< to the right, from where the horizon is level; in [-pi, pi)

  /// World from head.
  Quat orientation() const { return head_orientation(heading, roll_rad); }
};

/// The pose of a head with that orientation (world from head), whose roll is rounded to 1/65536 of
/// a turn (0.0055 degrees), as the record keeps it: so a replay sees the very same view.
HeadPose head_pose(Nanoseconds time, const Quat& orientation);

class HeadTracker {
 public:
  virtual ~HeadTracker() = default;
  /// The newest pose at `now`, which does not go backwards between calls; waits for nothing.
  virtual HeadPose pose(Nanoseconds now) = 0;
  /// The pose at `then`, when the eye tracker saw the eye that is followed at `now`. That of `now`
  /// where no past is known.
  virtual HeadPose pose_at_gaze(Nanoseconds /*then*/, Nanoseconds now) { return pose(now); }
  /// Whoever looks straight ahead looks along `heading` from now on, with the horizon level, where
  /// that is for a tracker to choose.
  virtual void face(const AzimuthElevation& /*heading*/) {}
};

/// Passes through given poses in time, turning at constant speed between them (the short way
/// round); before the first and after the last it stands still.
class ScriptedHeadTracker final : public HeadTracker {
 public:
  /// poses: at least one, times ascending. Throws Error otherwise.
  explicit ScriptedHeadTracker(std::vector<HeadPose> poses);
  HeadPose pose(Nanoseconds now) override;

 private:
  std::vector<HeadPose> poses_;
};

/// Follows a simulated head.
class SimulatedHeadTracker final : public HeadTracker {
 public:
  using TrueHeading = std::function<AzimuthElevation(Nanoseconds)>;
  explicit SimulatedHeadTracker(TrueHeading true_heading)
      : true_heading_(std::move(true_heading)) {}
  HeadPose pose(Nanoseconds now) override { return {.time = now, .heading = true_heading_(now)}; }

 private:
  TrueHeading true_heading_;
};

}  // namespace foveola
