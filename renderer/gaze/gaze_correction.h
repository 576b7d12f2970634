// What a calibration corrects, an affine map of the angles of gaze, and the check that finds it.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/gaze_quality.h"

namespace foveola {

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
