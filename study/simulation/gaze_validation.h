// Validates a simulated participant's gaze, in virtual time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

#include "renderer/base/clock.h"
#include "renderer/gaze/calibration.h"
#include "renderer/gaze/eye_tracker.h"
#include "study/participant/participant.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"

namespace foveola::study {

/// Shows the protocol's targets to the participant, and records its tracker's gaze: once, or, with
/// a correction, once to fit it and once through it. protocol: with validation. Advances `clock`
/// frame by frame. Empty if a stop was requested.
std::optional<GazeValidated> validate_gaze(const Protocol& protocol, Participant& participant,
                                           std::uint32_t tracker_seed, VirtualClock& clock,
                                           const std::stop_token& stop);

/// Returns the participant's tracker. participant must outlive it. seed: of its noise and losses.
std::unique_ptr<EyeTracker> watch(Participant& participant, const TrackerSettings& settings,
                                  std::uint32_t seed,
                                  const std::optional<GazeCorrection>& correction);

}  // namespace foveola::study
