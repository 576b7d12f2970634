// Where the head points: one interface for every source of head pose, and a head that a user
// turns.
#pragma once

#include <functional>
#include <mutex>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/base/vec.h"

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

/// A turn in azimuth and elevation.
struct Turn {
  double right_rad = 0.0;
  double up_rad = 0.0;
};

struct TurnSpeed {
  double right_rad_per_s = 0.0;
  double up_rad_per_s = 0.0;
};

/// One thread may steer while another asks for the pose. Steering says when it happened, so that a
/// key that is held turns the head by its speed times how long it was, whenever frames look. A
/// frame that does not know yet of what was before it goes on at the old speed; the next one is
/// right.
class SteeredHeadTracker final : public HeadTracker {
 public:
  /// start: what it looks at until it is turned; elevation in [-pi/2, pi/2].
  explicit SteeredHeadTracker(const AzimuthElevation& start);

  /// Turns at once, besides what the speed does. The azimuth goes round; the elevation stops at the
  /// zenith and at the nadir, and leaves them without delay. Times may not go backwards between
  /// calls that steer; one that does counts as the last one's.
  void turn(Nanoseconds time, const Turn& turn);

  /// Turns at this speed from `time` on, instead of what was set before. Who steers in several ways
  /// at a time sets the sum.
  void set_speed(Nanoseconds time, const TurnSpeed& speed);

  HeadPose pose(Nanoseconds now) override;

 private:
  /// At the speed that was set last.
  AzimuthElevation heading_at(Nanoseconds time) const;
  void go_on_to(Nanoseconds time);

  std::mutex mutex_;          ///< guards the members below
  AzimuthElevation heading_;  ///< the heading at `since_`
  TurnSpeed speed_;           ///< the turn's speed since then
  Nanoseconds since_{0};
};

/// Each stick's axes in [-1, 1], x rightwards and y downwards, as GLFW has them.
struct GamepadSticks {
  DVec2 left{0.0, 0.0};
  DVec2 right{0.0, 0.0};
};

/// What a stick does that is pushed so far from its middle, in whatever direction. The defaults are
/// chosen by judgement.
struct StickResponse {
  double dead_zone = 0.15;  ///< nothing up to here, where worn sticks rest; in [0, full_push)
  double full_push = 0.95;  ///< full speed from here on: not every stick reaches 1; in (0, 1]
  double exponent =
      2.0;  ///< exponent of the speed between, >= 1; above 1 it begins smoothly, for aiming
  double full_speed_rad_per_s = radians(120.0);  ///< >= 0
};

/// How fast the head turns: either stick turns it, and both together no faster than one. Sticks
/// whose axes are no numbers count as at rest.
TurnSpeed turn_speed(const GamepadSticks& sticks, const StickResponse& response);

}  // namespace foveola
