// Filters of gaze: smoothing, extrapolation, and holding the last valid sample.
#pragma once

#include <optional>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_movements.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// More than a gaze's age on a slow display; beyond, the eye has turned elsewhere meanwhile.
inline constexpr Nanoseconds longest_horizon = std::chrono::milliseconds(100);

/// Turns the gaze on by what the eye moves in a fixed time while it pursues something, or keeps to
/// it while the head turns. The angular velocity is the least-squares fit to the samples of the
/// last 100 ms since the last saccade and the last time without data, as EyeMovementDetector finds
/// them. It takes at least 5 samples over at least 40 ms, which trackers of 40 Hz and more send. In
/// a saccade and after a time without data samples stay as they are, and the fit begins anew.
///
/// Of the velocity v only the part max(0, 1 - 16 n / v^2) is believed, where n is the mean square
/// of what noise alone would make of it, known from how the samples scatter about the fit
/// (shrinkage in the manner of James and Stein 1961): nothing up to four times the root of n,
/// nearly all far above. So an eye at rest keeps its gaze as it is. The turn is at most 2 degrees,
/// so that whatever is taken for a movement, the eye stays well inside the 5.79 degrees within
/// which its acuity is full (see reddy_knee_deg).
///
/// Figures for samples at 120 Hz and a horizon of 30 ms. In a pursuit at 20 degrees per second the
/// gaze is 0.6 degrees behind where the eye is 30 ms later, and extrapolated not at all; with 0.1
/// degrees of noise along each axis its root mean square error falls from 0.61 to 0.16 degrees. At
/// rest this noise stays 0.1 degrees. After a saccade of 5 degrees or more the gaze is never beyond
/// its end; after one of up to 2 degrees, which may be too slow to be found, for less than 100 ms
/// by up to 0.31 of its amplitude.
class GazeExtrapolation {
 public:
  /// horizon: in (0, longest_horizon].
  explicit GazeExtrapolation(Nanoseconds horizon);

  /// The direction of the stream's next sample, turned on; that of an invalid one as it is. The
  /// intervals between samples may differ. A sample of the same time as the last one changes
  /// nothing in the velocity; an earlier one begins anew.
  Vec3 extrapolated(const GazeSample& sample);

 private:
  Nanoseconds horizon_;
  EyeMovementDetector detector_{EyeMovementSettings{}};
  std::optional<Nanoseconds> last_time_;
  std::vector<GazeSample> steady_;  ///< what the velocity is fitted to
};

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
