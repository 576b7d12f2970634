#include "study/simulation/gaze_validation.h"

#include <vector>

#include "renderer/view/viewport.h"
#include "study/stage/gaze_validation_runs.h"

namespace foveola::study {
namespace {

/// target: in the head's axes.
void show(const Vec3& target, Participant& participant, Nanoseconds now) {
  participant.look_at(head_orientation(participant.head(now)) * target, now);
}

}  // namespace

std::optional<GazeValidated> validate_gaze(const Protocol& protocol, Participant& participant,
                                           std::uint32_t tracker_seed, VirtualClock& clock,
                                           const std::stop_token& stop) {
  const auto tracker = watch(participant, protocol.tracker, tracker_seed, std::nullopt);
  GazeValidationRuns runs(*protocol.tracker.validation, protocol.display.horizontal_fov_deg,
                          protocol.display.vertical_fov_deg, clock.now());
  std::vector<GazeSample> arrived;
  std::optional<Vec3> shown;
  while (!runs.result()) {
    if (stop.stop_requested()) {
      return std::nullopt;
    }
    if (runs.target() != shown) {
      shown = runs.target();
      show(*shown, participant, clock.now());
    }
    clock.advance(nanoseconds_from_seconds(1.0 / protocol.machine.frame_rate_hz));
    arrived.clear();
    tracker->poll(clock.now(), arrived);
    runs.update(clock.now(), arrived);
  }
  return runs.result();
}

std::unique_ptr<EyeTracker> watch(Participant& participant, const TrackerSettings& settings,
                                  std::uint32_t seed,
                                  const std::optional<GazeCorrection>& correction) {
  SimulatedTrackerSettings simulated = settings.simulated;
  simulated.seed = seed;
  std::unique_ptr<EyeTracker> tracker =
      std::make_unique<SimulatedEyeTracker>(simulated, [&participant](Nanoseconds time) {
        return std::optional<Vec3>(gaze_in_head(participant.head(time), participant.gaze(time)));
      });
  if (correction) {
    tracker = std::make_unique<CorrectedEyeTracker>(std::move(tracker), *correction);
  }
  return tracker;
}

}  // namespace foveola::study
