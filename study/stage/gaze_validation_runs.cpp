#include "study/stage/gaze_validation_runs.h"

namespace foveola::study {

GazeValidationRuns::GazeValidationRuns(const ValidationSettings& settings,
                                       double horizontal_fov_deg, double vertical_fov_deg,
                                       Nanoseconds start)
    : settings_(settings),
      targets_(calibration_targets(settings.points, horizontal_fov_deg, vertical_fov_deg)),
      routine_(targets_, CalibrationTiming{}, start) {}

void GazeValidationRuns::update(Nanoseconds now, std::span<const GazeSample> arrived) {
  if (result_) {
    return;
  }
  std::vector<GazeSample> seen(arrived.begin(), arrived.end());
  if (correction_) {
    correct(seen, *correction_);
  }
  routine_.update(now, seen);
  if (!routine_.target()) {
    end_run(now);
  }
}

std::optional<Vec3> GazeValidationRuns::target() const {
  return result_ ? std::nullopt : routine_.target();
}

void GazeValidationRuns::end_run(Nanoseconds now) {
  const GazeQuality quality = gaze_quality(routine_.watched());
  runs_.push_back(
      {.quality = quality, .correction = correction_, .passed = passes(quality, settings_.gate)});
  const bool was_to_fit = settings_.correct && runs_.size() == 1;
  if (was_to_fit) {
    correction_ = fit_correction(quality.targets);
  }
  if (was_to_fit && correction_) {
    routine_ = CalibrationRoutine(targets_, CalibrationTiming{}, now);
  } else {
    // A run to which no correction can be fitted does not pass.
    result_ = GazeValidated{.runs = runs_, .passed = !was_to_fit && runs_.back().passed};
  }
}

}  // namespace foveola::study
