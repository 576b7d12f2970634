// The validation of a gaze, a person's or a simulated one: targets one after the other, as the
// protocol asks for them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/calibration.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"

namespace foveola::study {

/// Goes through the targets once, or, if the protocol asks for a correction, once to fit it and
/// once through it. Whoever drives it keeps the clock, shows the targets, and polls the tracker.
class GazeValidationRuns {
 public:
  /// The fields of view are the display's, in (0, 180). The first target appears at `start`.
  GazeValidationRuns(const ValidationSettings& settings, double horizontal_fov_deg,
                     double vertical_fov_deg, Nanoseconds start);

  /// Takes what the tracker said by `now`, as it came, without any correction.
  void update(Nanoseconds now, std::span<const GazeSample> arrived);

  /// What is to be looked at, in the head's axes; empty if all is done.
  std::optional<Vec3> target() const;

  /// What is now known; empty until all is done.
  const std::optional<GazeValidated>& result() const { return result_; }

 private:
  void end_run(Nanoseconds now);

  ValidationSettings settings_;
  std::vector<Vec3> targets_;
  CalibrationRoutine routine_;
  std::optional<GazeCorrection> correction_;  ///< what this run's gaze goes through
  std::vector<GazeRun> runs_;
  std::optional<GazeValidated> result_;
};

}  // namespace foveola::study
