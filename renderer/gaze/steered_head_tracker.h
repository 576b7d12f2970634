// A head that a user turns: by dragging the view, by keys, by a gamepad's sticks.
#pragma once

#include <mutex>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/head_tracker.h"

namespace foveola {

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
