#include "study/commands/gaze_validation.h"

#include <vector>

#include "renderer/gaze/calibration_routine.h"
#include "renderer/view/viewport.h"
#include "study/commands/watched_participant.h"

namespace foveola::study {
namespace {

/// Runs the protocol's targets, with or without a correction.
class TargetRuns {
 public:
  TargetRuns(const Protocol& protocol, Participant& participant, std::uint32_t tracker_seed,
             VirtualClock& clock, const std::stop_token& stop)
      : protocol_(protocol),
        participant_(participant),
        tracker_seed_(tracker_seed),
        clock_(clock),
        stop_(stop) {}

  std::optional<GazeRun> run(const std::optional<GazeCorrection>& correction) {
    CalibrationRoutine routine(targets(), {}, clock_.now());
    const auto tracker = watch(participant_, protocol_.tracker, tracker_seed_, correction);
    std::vector<GazeSample> arrived;
    std::optional<Vec3> shown;
    while (const std::optional<Vec3> target = routine.target()) {
      if (stop_.stop_requested()) {
        return std::nullopt;
      }
      if (target != shown) {
        show(*target);
        shown = target;
      }
      clock_.advance(nanoseconds_from_seconds(1.0 / protocol_.machine.frame_rate_hz));
      arrived.clear();
      tracker->poll(clock_.now(), arrived);
      routine.update(clock_.now(), arrived);
    }
    const GazeQuality quality = gaze_quality(routine.watched());
    return GazeRun{.quality = quality,
                   .correction = correction,
                   .passed = passes(quality, protocol_.tracker.validation->gate)};
  }

 private:
  std::vector<Vec3> targets() const {
    return calibration_targets(protocol_.tracker.validation->points,
                               protocol_.display.horizontal_fov_deg,
                               protocol_.display.vertical_fov_deg);
  }

  void show(const Vec3& target) {
    const Nanoseconds now = clock_.now();
    participant_.look_at(head_orientation(participant_.head(now)) * target, now);
  }

  const Protocol& protocol_;
  Participant& participant_;
  std::uint32_t tracker_seed_;
  VirtualClock& clock_;
  const std::stop_token& stop_;
};

}  // namespace

std::optional<GazeValidated> validate_gaze(const Protocol& protocol, Participant& participant,
                                           std::uint32_t tracker_seed, VirtualClock& clock,
                                           const std::stop_token& stop) {
  TargetRuns runs(protocol, participant, tracker_seed, clock, stop);
  std::optional<GazeRun> run = runs.run(std::nullopt);
  if (!run) {
    return std::nullopt;
  }
  GazeValidated validated{.runs = {*run}, .passed = run->passed};
  if (protocol.tracker.validation->correct) {
    const std::optional<GazeCorrection> correction = fit_correction(run->quality.targets);
    if (!correction) {
      validated.passed = false;
      return validated;
    }
    run = runs.run(correction);
    if (!run) {
      return std::nullopt;
    }
    validated.runs.push_back(*run);
    validated.passed = run->passed;
  }
  return validated;
}

}  // namespace foveola::study
