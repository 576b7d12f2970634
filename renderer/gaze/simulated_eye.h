// A simulated eye: fixations, saccades, microsaccades and blinks over time.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/vec.h"

namespace foveola {

/// Duration of a saccade, while it is fast enough to be noticed: 2.2 ms per degree and 21 ms
/// (Carpenter 1988).
double saccade_duration_s(double amplitude_deg);

/// Progress of a saccade of `amplitude_deg` in degrees, at a time relative to its middle (Dai et
/// al. 2016, with their eta = 600 degrees per second and c = 6 degrees). The maximum velocity is
/// eta (1 - exp(-amplitude / c)), in the middle. Beginning and end are gradual: outside its
/// duration the rest falls by a factor of e every 5 ms.
double saccade_progress_deg(double amplitude_deg, double since_middle_s);

struct SimulatedEyeSettings {
  std::uint64_t seed = 0;

  /// Between saccades; uniformly distributed (while viewing scenes, Henderson 2003).
  double shortest_fixation_s = 0.20;
  double longest_fixation_s = 0.35;
  /// Fixations are normally distributed around straight ahead: standard deviation in azimuth and in
  /// elevation, and maximum angle from straight ahead (few shifts leave +-20 degrees, Stahl 1999).
  /// The next one is at least smallest_saccade_deg away, and less than farthest_deg. 0 <
  /// smallest_saccade_deg <= spread_deg <= farthest_deg <= 90.
  double spread_deg = 10.0;
  double farthest_deg = 30.0;
  double smallest_saccade_deg = 1.0;

  /// Gamma-distributed: mean interval, with shape 5, and mean amplitude, with shape 4. An interval
  /// of 0 means none.
  double microsaccade_interval_s = 0.45;
  double microsaccade_amplitude_deg = 8.0 / 60.0;

  /// 0 means none. Durations are uniformly distributed. Blinks are at least half a second apart
  /// (assumed), so that their maximum is 60 / (0.5 + mean duration) per minute.
  double blinks_per_minute = 17.5;
  double shortest_blink_s = 0.1;
  double longest_blink_s = 0.4;
};

/// A saccade or microsaccade of the simulated eye.
struct SimulatedSaccade {
  Nanoseconds start{0};
  Nanoseconds end{0};  ///< after its duration; its middle is halfway
  DVec3 from{0.0, 0.0, -1.0};
  DVec3 to{0.0, 0.0, -1.0};
  double amplitude_deg = 0.0;  ///< the angle between them
  bool is_micro = false;
};

struct SimulatedBlink {
  Nanoseconds start{0};
  Nanoseconds end{0};
};

/// A deterministic function of its settings: its plan grows as needed, and does not depend on the
/// times asked for or their order. Time begins at 0, with the gaze straight ahead.
class SimulatedEye {
 public:
  explicit SimulatedEye(const SimulatedEyeSettings& settings);

  /// The direction in the head's axes, of unit length; nullopt during a blink. Before time 0 as at
  /// 0.
  std::optional<Vec3> gaze(Nanoseconds time);

  /// Those that start before `end`, in order of time.
  std::vector<SimulatedSaccade> saccades(Nanoseconds end);
  std::vector<SimulatedBlink> blinks(Nanoseconds end);

 private:
  void plan_saccades(Nanoseconds until);
  void plan_microsaccades(Nanoseconds fixation_end);
  void plan_blinks(Nanoseconds until);
  /// Adds a saccade from the current direction to `target`.
  void add_saccade(Nanoseconds start, const DVec3& target, bool is_micro);
  DVec3 next_fixation();
  DVec3 next_microsaccade_target(double amplitude_deg);

  SimulatedEyeSettings settings_;
  Pcg32 saccade_random_;
  Pcg32 microsaccade_random_;
  Pcg32 blink_random_;

  std::vector<SimulatedSaccade> saccades_;
  std::vector<SimulatedBlink> blinks_;
  Nanoseconds still_since_{0};  ///< end of the plan's last saccade
  Nanoseconds next_microsaccade_{0};
  DVec3 fixation_{0.0, 0.0, -1.0};   ///< target of the last saccade, without microsaccades
  DVec3 direction_{0.0, 0.0, -1.0};  ///< target of the last saccade of either kind
};

}  // namespace foveola
