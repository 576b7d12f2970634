// Filters of gaze: smoothing, extrapolation, and holding the last valid sample.
#pragma once

#include <optional>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_movements.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// Above a gaze's age on a slow display; beyond, the eye has turned elsewhere meanwhile.
inline constexpr Nanoseconds longest_horizon = std::chrono::milliseconds(100);

/// Extrapolates the gaze over a fixed time during pursuit, and during fixation while the head
/// turns. The angular velocity is a least-squares fit to the samples of the last 100 ms since the
/// last saccade and gap, as EyeMovementDetector finds them. It needs at least 5 samples over at
/// least 40 ms, as sent by trackers of 40 Hz and more. In a saccade and after a gap samples are
/// unchanged, and the fit begins anew.
///
/// The velocity v is shrunk by the factor max(0, 1 - 16 n / v^2), in the manner of James and Stein
/// 1961. Here n is the mean square of the velocity due to noise alone, estimated from the
/// residuals. The factor is 0 up to four times the root of n, and nearly 1 far above: an eye at
/// rest keeps its gaze unchanged. The turn is at most 2 degrees, so that any error stays well
/// inside the 5.79 degrees of full acuity (see reddy_knee_deg).
///
/// Figures for samples at 120 Hz and a horizon of 30 ms. In a pursuit at 20 degrees per second the
/// gaze lags by 0.6 degrees, and extrapolated not at all. With 0.1 degrees of noise along each axis
/// the root mean square error falls from 0.61 to 0.16 degrees. At rest this noise stays 0.1
/// degrees. After a saccade of 5 degrees or more the gaze never overshoots. After one of up to 2
/// degrees, which may be too slow for detection, it overshoots by up to 0.31 of the amplitude for
/// less than 100 ms.
class GazeExtrapolation {
 public:
  /// horizon: in (0, longest_horizon].
  explicit GazeExtrapolation(Nanoseconds horizon);

  /// The extrapolated direction of the next sample; that of an invalid one is unchanged. Intervals
  /// between samples may vary. A sample with the time of the last one does not change the velocity;
  /// an earlier one resets the fit.
  Vec3 extrapolated(const GazeSample& sample);

 private:
  Nanoseconds horizon_;
  EyeMovementDetector detector_{EyeMovementSettings{}};
  std::optional<Nanoseconds> last_time_;
  std::vector<GazeSample> steady_;  ///< samples of the fit
};

/// The defaults suit a simulated tracker of 120 Hz with 0.1 degrees of noise: a third of the noise
/// remains, and a lag of 0.4 degrees at the end of a saccade of 10 degrees. To tune them, first
/// lower min_cutoff_hz with the eye at rest until jitter is gone, then raise beta until saccades no
/// longer lag.
struct OneEuroSettings {
  double min_cutoff_hz = 1.0;          ///< > 0: of the low-pass filter at rest
  double beta_per_deg = 0.3;           ///< >= 0: Hz added per degree per second
  double derivative_cutoff_hz = 10.0;  ///< > 0: of the velocity's low-pass filter
  /// A longer gap between samples resets the filter.
  Nanoseconds reset_after = std::chrono::milliseconds(100);

  bool operator==(const OneEuroSettings&) const = default;
};

/// The 1-Euro filter (Casiez, Roussel and Vogel 2012, algorithms 1 and 2) on the sphere: a value is
/// a direction, a difference is a turn, and the derivative is an angular velocity, as a vector.
/// Along a great circle it is the published filter of the angle.
class OneEuro {
 public:
  explicit OneEuro(const OneEuroSettings& settings);

  /// The smoothed direction at `time`. Intervals between samples may vary. The last time again
  /// gives the last result; an earlier time resets the filter.
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

/// About the maximum duration of a blink.
inline constexpr Nanoseconds longest_hold = std::chrono::milliseconds(600);

/// Withholds invalid samples, so that the newest output stays the last valid sample, with its own
/// time, until that is too old. Then invalid samples pass, or one is added if none arrived.
class GazeHold {
 public:
  /// limit: the maximum age (now minus the sample's time); in (0, longest_hold].
  explicit GazeHold(Nanoseconds limit);
  /// The output for the samples that arrived by `now`.
  std::vector<GazeSample> passed(Nanoseconds now, const std::vector<GazeSample>& arrived);

 private:
  Nanoseconds limit_;
  std::optional<Nanoseconds> held_;  ///< time of the last valid sample, until it is too old
};

/// The filters to use; by default none.
struct GazeFilterSettings {
  std::optional<OneEuroSettings> one_euro;
  std::optional<double> extrapolate_s;  ///< the horizon of a GazeExtrapolation
  std::optional<double> hold_s;         ///< the limit of a GazeHold

  bool operator==(const GazeFilterSettings&) const = default;
};

/// The user's range of a setting, including both ends.
struct SettingRange {
  double least = 0.0;
  double most = 0.0;
};
inline constexpr SettingRange hold_range_s{.least = 0.001, .most = 0.6};
inline constexpr SettingRange horizon_range_s{.least = 0.001, .most = 0.1};
inline constexpr SettingRange cutoff_range_hz{.least = 0.01, .most = 1000.0};
inline constexpr SettingRange beta_range_per_deg{.least = 0.0, .most = 100.0};

/// Smooths, extrapolates and then holds a stream of samples, as configured. Extrapolation amplifies
/// noise, so smoothing comes first; smoothing afterwards would bring back some of the lag. Holding
/// comes last, since it holds the final result. Samples keep their own times. Directions do not
/// depend on whether samples come one by one or together.
class GazeFilter {
 public:
  explicit GazeFilter(const GazeFilterSettings& settings);

  /// The output for the samples that arrived by `now` since the last call; without a filter they
  /// are unchanged. Times must not decrease between calls.
  std::vector<GazeSample> filtered(Nanoseconds now, std::vector<GazeSample> arrived);

 private:
  std::optional<OneEuro> one_euro_;
  std::optional<GazeExtrapolation> extrapolation_;
  std::optional<GazeHold> hold_;
};

}  // namespace foveola
