// Calibration: targets, their presentation, and the affine correction of gaze angles.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_movements.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/gaze_quality.h"

namespace foveola {

/// Directions in the head's axes: the middle of the view and its corners (5), or the middle and a
/// grid around it (9). They extend to four fifths of the half field of view, but to at most 20
/// degrees, beyond which few gaze shifts occur without the head (Stahl 1999). points: 5 or 9.
/// Fields of view in (0, 180).
std::vector<Vec3> calibration_targets(int points, double horizontal_fov_deg,
                                      double vertical_fov_deg);

/// All assumed; a saccade to a target begins after 0.2 s and ends within 0.1 s.
struct CalibrationTiming {
  Nanoseconds settle = std::chrono::milliseconds(700);  ///< before a target's samples count
  Nanoseconds collect = std::chrono::seconds(1);        ///< duration of valid gaze to collect then
  /// Longer intervals between valid samples do not count.
  Nanoseconds longest_interval = EyeMovementSettings{}.longest_interval;
  Nanoseconds give_up = std::chrono::seconds(4);  ///< after a target's appearance; > settle
};

/// Shows each target until its samples are collected or given up. It depends on its arguments
/// alone: the caller keeps the clock, shows the target, and polls the tracker.
class CalibrationRoutine {
 public:
  /// targets: at least one. The first appears at `start`.
  CalibrationRoutine(std::vector<Vec3> targets, const CalibrationTiming& timing, Nanoseconds start);

  /// Takes the samples up to `now`. If the target is finished, the next one appears at `now`.
  void update(Nanoseconds now, std::span<const GazeSample> arrived);

  /// The current target in the head's axes; nullopt at the end.
  std::optional<Vec3> target() const;
  /// The finished targets.
  const std::vector<WatchedTarget>& watched() const { return watched_; }

 private:
  /// Returns whether the target's samples suffice.
  bool collect(const GazeSample& sample);
  void show_next(Nanoseconds now);

  std::vector<Vec3> targets_;
  CalibrationTiming timing_;
  std::vector<WatchedTarget> watched_;
  WatchedTarget watching_;
  Nanoseconds collected_{0};
  std::optional<Nanoseconds> last_valid_;
};

/// An affine map of azimuth and elevation in the head's axes, in degrees. A row holds the weights
/// of 1, of the measured azimuth and of the measured elevation; their weighted sum is the corrected
/// angle.
struct GazeCorrection {
  DVec3 azimuth{0.0, 1.0, 0.0};
  DVec3 elevation{0.0, 0.0, 1.0};

  bool operator==(const GazeCorrection&) const = default;
};

/// direction: unit length, like the result.
Vec3 corrected(const Vec3& direction, const GazeCorrection& correction);

/// Corrects the valid samples of `samples`.
void correct(std::span<GazeSample> samples, const GazeCorrection& correction);

/// The correction that applies `first` and then `second`.
GazeCorrection combined(const GazeCorrection& first, const GazeCorrection& second);

/// Fits the affine correction that maps the mean gaze on each target to that target, by least
/// squares in degrees. Skips targets without gaze. nullopt if the mean gazes are nearly collinear:
/// if along some direction they deviate from their mean by less than a degree.
std::optional<GazeCorrection> fit_correction(std::span<const TargetQuality> targets);

/// Corrects the valid samples of another tracker. Without a correction samples stay unchanged, to
/// the bit.
class CorrectedEyeTracker final : public EyeTracker {
 public:
  explicit CorrectedEyeTracker(std::unique_ptr<EyeTracker> source,
                               const GazeCorrection& correction = {});
  /// Applies another correction after the present one, from the next poll.
  void add(const GazeCorrection& correction);
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override { return source_->status(); }

 private:
  std::unique_ptr<EyeTracker> source_;
  GazeCorrection correction_;
};

/// A check of the tracker: its quality, and the correction from then on.
struct GazeCheck {
  GazeQuality quality;
  std::optional<GazeCorrection> correction;  ///< the tracker's correction after the check, if any
};

/// Judges the tracker by watched targets, at least one, as `tracker` measured them. corrects:
/// whether to correct the measured errors from now on, if they suffice to fit a correction.
GazeCheck check_gaze(std::span<const WatchedTarget> watched, bool corrects,
                     CorrectedEyeTracker& tracker);

}  // namespace foveola
