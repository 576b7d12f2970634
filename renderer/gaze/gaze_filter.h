// Optional filters of a tracker's gaze: one smooths it, one makes up for its age, one holds it
// through blinks.
#pragma once

#include <optional>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/gaze_extrapolation.h"

namespace foveola {

/// The defaults suit a simulated tracker of 120 Hz with 0.1 degrees of noise: a third of the noise
/// is left, and at the end of a saccade of 10 degrees 0.4 are still to go. To tune them, first
/// lower min_cutoff_hz with the eye at rest until jitter is gone, then raise beta until saccades no
/// longer lag.
struct OneEuroSettings {
  double min_cutoff_hz = 1.0;          ///< > 0: of the low pass for an eye at rest
  double beta_per_deg = 0.3;           ///< >= 0: Hz more for each degree per second
  double derivative_cutoff_hz = 10.0;  ///< > 0: of the low pass of the velocity
  /// After a longer time without samples it begins anew.
  Nanoseconds reset_after = std::chrono::milliseconds(100);

  bool operator==(const OneEuroSettings&) const = default;
};

/// The 1-Euro filter (Casiez, Roussel and Vogel 2012, algorithms 1 and 2) on the sphere: a value is
/// a direction, a difference is a turn, and the derivative is an angular velocity, as a vector.
/// Along a great circle it is the published filter of the angle.
class OneEuro {
 public:
  explicit OneEuro(const OneEuroSettings& settings);

  /// The smoothed direction at `time`. The intervals between samples may differ. Of the same time
  /// as the last one: what it was; earlier: begins anew.
  Vec3 smoothed(Nanoseconds time, const Vec3& direction);

 private:
  struct State {
    Nanoseconds time{0};
    DVec3 direction{0.0, 0.0, -1.0};
    DVec3 velocity_deg_s{0.0, 0.0, 0.0};
  };

  OneEuroSettings settings_;
  std::optional<State> state_;
};

/// About the longest time that a blink lasts.
inline constexpr Nanoseconds longest_hold = std::chrono::milliseconds(600);

/// Keeps invalid samples back, so that the newest that passed stays the last valid one, with its
/// own time, until that is too old. From then on they pass, and one is added if none came.
class GazeHold {
 public:
  /// limit: the age (now less the sample's time) beyond which it is too old; in (0, longest_hold].
  explicit GazeHold(Nanoseconds limit);
  /// What passes of the samples that arrived by `now`.
  std::vector<GazeSample> passed(Nanoseconds now, const std::vector<GazeSample>& arrived);

 private:
  Nanoseconds limit_;
  std::optional<Nanoseconds> held_;  ///< the time of the last valid sample, until it is too old
};

/// Which of the filters are wanted; by default none.
struct GazeFilterSettings {
  std::optional<OneEuroSettings> one_euro;
  std::optional<double> extrapolate_s;  ///< the horizon of a GazeExtrapolation
  std::optional<double> hold_s;         ///< the limit of a GazeHold

  bool operator==(const GazeFilterSettings&) const = default;
};

/// Where a user may set them, both ends included.
struct SettingRange {
  double least = 0.0;
  double most = 0.0;
};
inline constexpr SettingRange hold_range_s{.least = 0.001, .most = 0.6};
inline constexpr SettingRange horizon_range_s{.least = 0.001, .most = 0.1};
inline constexpr SettingRange cutoff_range_hz{.least = 0.01, .most = 1000.0};
inline constexpr SettingRange beta_range_per_deg{.least = 0.0, .most = 100.0};

/// Smooths, extrapolates and then holds a stream of samples, so far as wanted. Extrapolation
/// multiplies noise, so it comes once there is less of it; to smooth what was extrapolated would
/// bring back some of the age that was made up for. What is held is what was used last, so that
/// comes at the end. Samples keep their own times. Whether they come one by one or several together
/// makes no difference to their directions.
class GazeFilter {
 public:
  explicit GazeFilter(const GazeFilterSettings& settings);

  /// What becomes of the samples that arrived by `now`, after those of the call before; without a
  /// filter they stay as they are. Time may not go backwards between calls.
  std::vector<GazeSample> filtered(Nanoseconds now, std::vector<GazeSample> arrived);

 private:
  std::optional<OneEuro> one_euro_;
  std::optional<GazeExtrapolation> extrapolation_;
  std::optional<GazeHold> hold_;
};

}  // namespace foveola
