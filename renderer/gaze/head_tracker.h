// The interface of all head-pose sources, and a head steered by the user.
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
  double roll_rad = 0.0;     ///< to the right, from a level horizon; in [-pi, pi)

  /// World from head.
  Quat orientation() const { return head_orientation(heading, roll_rad); }
};

/// The pose of a head with this orientation (world from head). The roll is rounded to 1/65536 of a
/// turn (0.0055 degrees), as in the record, so that a replay has exactly the same view.
HeadPose head_pose(Nanoseconds time, const Quat& orientation);

class HeadTracker {
 public:
  virtual ~HeadTracker() = default;
  /// The newest pose at `now`, which must not decrease between calls. Does not wait.
  virtual HeadPose pose(Nanoseconds now) = 0;
  /// The pose at `then`, the time of the gaze that is used at `now`. Without a history, the pose at
  /// `now`.
  virtual HeadPose pose_at_gaze(Nanoseconds /*then*/, Nanoseconds now) { return pose(now); }
  /// Makes straight ahead the direction `heading`, with a level horizon, if the tracker can choose
  /// it.
  virtual void face(const AzimuthElevation& /*heading*/) {}
};

/// Interpolates given poses in time, turning at constant speed (the short way round); constant
/// before the first and after the last.
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

/// One thread may steer while another asks for the pose. Steering has times, so that a held key
/// turns the head by its speed times its duration, independent of frames. A frame that precedes an
/// event uses the old speed; the next one is correct.
class SteeredHeadTracker final : public HeadTracker {
 public:
  /// start: the initial direction; elevation in [-pi/2, pi/2].
  explicit SteeredHeadTracker(const AzimuthElevation& start);

  /// Turns at once, in addition to the speed. The azimuth wraps; the elevation stops at the zenith
  /// and the nadir, and leaves them without delay. Times should not decrease between steering
  /// calls; an earlier time counts as the last one.
  void turn(Nanoseconds time, const Turn& turn);

  /// Sets the speed from `time` on. Callers with several inputs set their sum.
  void set_speed(Nanoseconds time, const TurnSpeed& speed);

  HeadPose pose(Nanoseconds now) override;

 private:
  /// At the last speed.
  AzimuthElevation heading_at(Nanoseconds time) const;
  void go_on_to(Nanoseconds time);

  std::mutex mutex_;          ///< guards the members below
  AzimuthElevation heading_;  ///< the heading at `since_`
  TurnSpeed speed_;           ///< the speed since then
  Nanoseconds since_{0};
};

/// Each stick's axes in [-1, 1], x rightwards and y downwards, as in GLFW.
struct GamepadSticks {
  DVec2 left{0.0, 0.0};
  DVec2 right{0.0, 0.0};
};

/// The speed of a stick as a function of its distance from the centre, in any direction. Defaults
/// chosen by judgement.
struct StickResponse {
  double dead_zone = 0.15;  ///< no response below, where worn sticks rest; in [0, full_push)
  double full_push = 0.95;  ///< full speed above, since not every stick reaches 1; in (0, 1]
  double exponent =
      2.0;  ///< exponent of the speed between, >= 1; above 1 it begins smoothly, for aiming
  double full_speed_rad_per_s = radians(120.0);  ///< >= 0
};

/// The head's turning speed: either stick turns it, both together no faster than one. Sticks with
/// NaN axes count as at rest.
TurnSpeed turn_speed(const GamepadSticks& sticks, const StickResponse& response);

}  // namespace foveola
