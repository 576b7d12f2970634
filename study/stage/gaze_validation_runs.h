// Validates a gaze, real or simulated, with one target after the other.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/calibration.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"

namespace foveola::study {

/// Goes through the targets once, or, with a correction, once to fit it and once through it. The
/// caller keeps the clock, shows the targets, and polls the tracker.
class GazeValidationRuns {
 public:
  /// The fields of view are the display's, in (0, 180). The first target appears at `start`.
  GazeValidationRuns(const ValidationSettings& settings, double horizontal_fov_deg,
                     double vertical_fov_deg, Nanoseconds start);

  /// Adds the tracker's samples until `now`, uncorrected.
  void update(Nanoseconds now, std::span<const GazeSample> arrived);

  /// Returns the current target, in the head's axes; empty at the end.
  std::optional<Vec3> target() const;

  /// Returns the result; empty until the end.
  const std::optional<GazeValidated>& result() const { return result_; }

 private:
  void end_run(Nanoseconds now);

  ValidationSettings settings_;
  std::vector<Vec3> targets_;
  CalibrationRoutine routine_;
  std::optional<GazeCorrection> correction_;  ///< the gaze's correction in this run
  std::vector<GazeRun> runs_;
  std::optional<GazeValidated> result_;
};

}  // namespace foveola::study
