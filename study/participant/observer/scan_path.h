// Generates the scan path of a simulated participant: fixations, saccades and turns of the head
// over time.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/base/numbers/random.h"
#include "study/participant/population.h"

namespace foveola::study {

/// The path is extended as time passes. Equal seeds and calls give equal paths, at whatever times
/// they are evaluated.
class ScanPath {
 public:
  ScanPath(const GazeHabits& habits, std::uint64_t seed);

  /// After the saccadic latency from `start` on, the eye moves to `target` (unit length, world) and
  /// stays; the head does not move.
  void fixate(const Vec3& target, Nanoseconds start);
  /// From `start` on the head faces `object` (unit length, world) and the eye wanders over it.
  void examine(const Vec3& object, double radius_deg, Nanoseconds start);
  /// From `start` on head and eye look around, to both sides of `azimuth_rad`.
  void explore(double azimuth_rad, Nanoseconds start);

  /// Return the eye's direction in world axes and the head's heading at `time`; before the last
  /// start, those at the start.
  Vec3 gaze(Nanoseconds time);
  AzimuthElevation head(Nanoseconds time);

  /// A saccade and the fixation that it leads to.
  struct Fixation {
    Nanoseconds begin{0};    ///< Start of the saccade.
    Nanoseconds landing{0};  ///< End of the saccade.
    Nanoseconds end{0};      ///< Start of the next saccade; the maximum time if there is none.
    Vec3 direction{0.0F, 0.0F, -1.0F};  ///< Direction of the eye after landing; unit length, world.
  };
  /// Returns the fixation with `time` in [begin, end), so that fixation(f.end) follows f; before
  /// the last start, that at the start.
  Fixation fixation(Nanoseconds time);

 private:
  struct Saccade {
    Nanoseconds start{0};
    Nanoseconds end{0};
    Vec3 target{0.0F, 0.0F, -1.0F};
    std::size_t turn = 0;  ///< Turn of the head that carries it; 0: none.
  };
  struct HeadTurn {
    Nanoseconds start{0};
    Nanoseconds end{0};
    AzimuthElevation heading;
  };

  long fixations_per_turn() const { return std::lround(habits_.fixations_per_head_turn); }
  /// Discards the path except the directions of head and eye at `start`.
  void begin(Nanoseconds start);
  /// Adds a turn of the head. The previous turn must be over, or have begun at `start`.
  void turn_head(const AzimuthElevation& heading, Nanoseconds start);
  bool wanders() const { return exploring_ || radius_deg_ > 0.0; }
  /// Adds saccades until the eye rests beyond `time`.
  void continue_to(Nanoseconds time);
  /// Returns the time at which the eye lands: at the end of the saccade, or later, with the head,
  /// if a turn that began with it carries the eye.
  Nanoseconds add_saccade(const Vec3& target, Nanoseconds start);
  Vec3 next_target();
  Vec3 target_on_object();
  Vec3 target_around();

  GazeHabits habits_;
  Pcg32 random_;
  std::vector<Saccade> saccades_;  ///< The first stands for the eye's direction at the start.
  std::vector<HeadTurn> turns_;    ///< The first stands for the head's heading at the start.
  Nanoseconds next_saccade_{0};
  bool exploring_ = false;
  long fixations_since_turn_ = 0;
  Vec3 object_{0.0F, 0.0F, -1.0F};
  double radius_deg_ = 0.0;
  double around_azimuth_rad_ = 0.0;
};

}  // namespace foveola::study
