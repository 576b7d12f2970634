// One attempt at a trial of a simulated session, rendered or predicted.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "renderer/base/clock.h"
#include "renderer/gaze/calibration.h"
#include "study/design/plan.h"
#include "study/participant/participant.h"
#include "study/protocol/protocol.h"
#include "study/record/session_recorder.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// The seeds of one timing of a trial.
struct TrialSeeds {
  std::uint32_t tracker = 0;
  std::uint32_t rendering = 0;
  std::uint32_t picture = 0;  ///< the same for all timings of a trial
};

/// Inputs of an attempt; it refers to most of them.
struct TrialAttemptSetting {
  const SceneStage& stage;
  const Protocol& protocol;
  const PlannedTrial& trial;
  const OfferedObject& object;  ///< the object that the participant looks at
  TrialSeeds seeds;
  Participant& participant;
  std::optional<GazeCorrection> correction;
  VirtualClock& clock;           ///< the attempt's; rendering starts at its `now`
  Nanoseconds attempt_start{0};  ///< session time at which the attempt's clock is 0
  SessionRecorder& recorder;
  AttemptKey key;
};

class TrialAttempt {
 public:
  virtual ~TrialAttempt() = default;

  /// Presents at least the next frame, and at most until one is on the display at `until` (of the
  /// attempt) or later. Advances the clock to the presentation of the last one. Returns the time of
  /// the key press that a glance at it caused.
  virtual std::optional<Nanoseconds> show(Nanoseconds until) = 0;

  /// The participant's task from now on.
  virtual void begin(Task task) = 0;

  /// Passes all remaining data to the record.
  virtual void complete_record() = 0;

  /// Number of samples traced so far.
  virtual std::uint64_t samples() const = 0;
  /// Number of them that were not finite.
  virtual std::uint64_t non_finite() const = 0;
};

using MakeAttempt = std::function<std::unique_ptr<TrialAttempt>(const TrialAttemptSetting&)>;

/// Interval of a simulated participant's looks (see glance_interval_s).
std::uint64_t frames_per_glance(const MachineModel& machine);

}  // namespace foveola::study
