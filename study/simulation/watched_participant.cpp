#include "study/simulation/watched_participant.h"

#include "renderer/view/viewport.h"

namespace foveola::study {

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
