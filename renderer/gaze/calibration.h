// Calibration: the targets to look at, and the affine correction of gaze angles that follows.
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
/// grid around it (9). Across and up, they reach to four fifths of the way to the edge of the view,
/// but not beyond 20 degrees, where few shifts of gaze go without the head (Stahl 1999). points: 5
/// or 9. Fields of view in (0, 180).
std::vector<Vec3> calibration_targets(int points, double horizontal_fov_deg,
                                      double vertical_fov_deg);

/// All assumed; a saccade to a target begins after 0.2 s and is over within 0.1 s.
struct CalibrationTiming {
  Nanoseconds settle = std::chrono::milliseconds(700);  ///< until a target's samples count
  Nanoseconds collect = std::chrono::seconds(1);  ///< how long the gaze must be known for then
  /// A longer interval between valid samples does not count.
  Nanoseconds longest_interval = EyeMovementSettings{}.longest_interval;
  Nanoseconds give_up = std::chrono::seconds(4);  ///< after a target's appearance; > settle
};

/// Shows a target until its samples are collected or given up, then the next. It depends
/// on its arguments alone: whoever drives it keeps the clock, shows the target, and polls the
/// tracker.
class CalibrationRoutine {
 public:
  /// targets: at least one. The first appears at `start`.
  CalibrationRoutine(std::vector<Vec3> targets, const CalibrationTiming& timing, Nanoseconds start);

  /// Takes what has arrived by `now`. If a target is done with, the next one appears at `now`.
  void update(Nanoseconds now, std::span<const GazeSample> arrived);

  /// What is to be looked at, in the head's axes; empty if all is done.
  std::optional<Vec3> target() const;
  /// The targets that are done with.
  const std::vector<WatchedTarget>& watched() const { return watched_; }

 private:
  /// Returns whether that was enough.
  bool collect(const GazeSample& sample);
  void show_next(Nanoseconds now);

  std::vector<Vec3> targets_;
  CalibrationTiming timing_;
  std::vector<WatchedTarget> watched_;
  WatchedTarget watching_;
  Nanoseconds collected_{0};
  std::optional<Nanoseconds> last_valid_;
};

/// An affine map of azimuth and elevation in the head's axes, in degrees. A row's components are
/// the weights of 1, of the seen azimuth and of the seen elevation; their sum is the corrected
/// angle.
struct GazeCorrection {
  DVec3 azimuth{0.0, 1.0, 0.0};
  DVec3 elevation{0.0, 0.0, 1.0};

  bool operator==(const GazeCorrection&) const = default;
};

/// direction: of unit length, as is what is returned.
Vec3 corrected(const Vec3& direction, const GazeCorrection& correction);

/// Corrects the valid ones of `samples`.
void correct(std::span<GazeSample> samples, const GazeCorrection& correction);

/// The correction that applies `first` and then `second`.
GazeCorrection combined(const GazeCorrection& first, const GazeCorrection& second);

/// Takes the mean gaze on each target that was seen to the target, as closely as can be in the
/// least squares of angles. Empty if the gazes lie so nearly on a line or a point that they do not
/// determine it: if along some direction they deviate from their mean by less than a degree.
std::optional<GazeCorrection> fit_correction(std::span<const TargetQuality> targets);

/// Corrects the valid samples that pass through it. As long as there is nothing to correct they
/// stay as they are, to the bit.
class CorrectedEyeTracker final : public EyeTracker {
 public:
  explicit CorrectedEyeTracker(std::unique_ptr<EyeTracker> source,
                               const GazeCorrection& correction = {});
  /// Corrects what it has corrected so far once more, from the next poll on.
  void add(const GazeCorrection& correction);
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override { return source_->status(); }

 private:
  std::unique_ptr<EyeTracker> source_;
  GazeCorrection correction_;
};

/// A check of the tracker: how good it is, and what is corrected from then on.
struct GazeCheck {
  GazeQuality quality;
  std::optional<GazeCorrection> correction;  ///< what the tracker corrects since then, if anything
};

/// Judges the tracker by targets that were looked at, at least one, as `tracker` saw them.
/// corrects: whether it corrects from now on what they show, if they suffice to fit a correction.
GazeCheck check_gaze(std::span<const WatchedTarget> watched, bool corrects,
                     CorrectedEyeTracker& tracker);

}  // namespace foveola
