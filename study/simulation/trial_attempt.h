// One attempt at a trial of a simulated session, rendered or predicted.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "renderer/base/clock.h"
#include "renderer/gaze/calibration.h"
#include "study/design/plan.h"
#include "study/driver/ports.h"
#include "study/participant/participant.h"
#include "study/protocol/protocol.h"
#include "study/record/write/session_recorder.h"
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
  std::optional<Nanoseconds>& pressed;  ///< session clock: when the task's key goes down
};

class TrialAttempt : public AttemptPort {
 public:
  explicit TrialAttempt(const TrialAttemptSetting& setting) : setting_(setting) {}

  /// Notes the first press of the task's key.
  Nanoseconds show(Nanoseconds until) final {
    const std::optional<Nanoseconds> press = show_frames(until - setting_.attempt_start);
    if (press && !setting_.pressed) {
      setting_.pressed = setting_.attempt_start + *press;
    }
    return setting_.attempt_start + setting_.clock.now();
  }

  /// The participant's task from now on.
  virtual void begin(Task /*task*/) {}

 protected:
  /// Presents at least the next frame, and at most until one is on the display at `until` (of the
  /// attempt) or later. Advances the clock to the presentation of the last one. Returns the time of
  /// the key press that a glance at it caused.
  virtual std::optional<Nanoseconds> show_frames(Nanoseconds until) = 0;

  const TrialAttemptSetting setting_;
};

using MakeAttempt = std::function<std::unique_ptr<TrialAttempt>(const TrialAttemptSetting&)>;

/// Interval of a simulated participant's looks (see glance_interval_s).
std::uint64_t frames_per_glance(const MachineModel& machine);

}  // namespace foveola::study
