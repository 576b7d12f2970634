// The protocol's tracker, watching a simulated participant.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/gaze_correction.h"
#include "study/participant/participant.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// participant: must outlive the tracker. seed: of the tracker's noise and losses.
std::unique_ptr<EyeTracker> watch(Participant& participant, const TrackerSettings& settings,
                                  std::uint32_t seed,
                                  const std::optional<GazeCorrection>& correction);

}  // namespace foveola::study
