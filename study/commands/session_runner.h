// The controller of a session: it waits for what the session waits for, records each event, and
// only then lets it have its effects.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "renderer/base/clock.h"
#include "study/commands/attempt_log.h"
#include "study/commands/scene_stage.h"
#include "study/commands/virtual_preview.h"
#include "study/design/plan.h"
#include "study/participant/participant.h"
#include "study/session/session.h"

namespace foveola::study {

/// What a session needs and does not own.
struct SessionSetting {
  const Protocol& protocol;
  const SceneStages& stages;
  StudyStore& store;
  const Workers& workers;
  /// The seeds for an attempt at a trial.
  std::function<AttemptSeeds(const PlannedTrial&, int attempt)> seeds;
  std::uint32_t validation_seed = 0;  ///< of the tracker while the gaze is validated
  /// Called when a trial begins, with its index.
  std::function<void(std::size_t trial)> on_trial;
  std::stop_token stop;
};

struct SessionOutcome {
  Phase phase = Phase::created;  ///< completed, refused or interrupted
  std::size_t trials = 0;        ///< completed ones
  Nanoseconds duration{0};       ///< session clock
  std::uint64_t samples = 0;
  std::uint64_t non_finite = 0;
};

/// Runs one session in virtual time, from its start until it is completed, refused by the
/// protocol's gate, or interrupted because a stop was requested.
class SessionRunner {
 public:
  /// session: the row that StudyStore::begin_session returned for `plan`.
  SessionRunner(const SessionSetting& setting, const Plan& plan, std::int64_t session,
                Participant& participant);

  SessionOutcome run();

 private:
  // What the session waits for, as an event; a stop request comes first.
  Event next_event();
  Event start() const;
  Event validate();
  Event answer_background();
  Event choose_object();
  Event present_first_frame();
  Event wait_for_mark();
  Event rate();

  /// Records the event, takes the session's step, and carries out the effects.
  void feed(const Event& event);
  void carry_out(const Effect& effect);
  void start_rendering();
  void stop_rendering();

  /// Renders and presents one frame; every few frames shows it to the participant, whose key press
  /// it returns.
  std::optional<Nanoseconds> show_frame();
  const PlannedTrial& trial() const { return plan_[state_.trial]; }
  const SceneStage& stage() const { return *setting_.stages.at(trial().scene); }

  SessionSetting setting_;
  const Plan& plan_;
  std::int64_t session_;
  Participant& participant_;
  VirtualClock clock_;
  SessionState state_;
  std::optional<GazeCorrection> correction_;
  std::optional<VirtualPreview> preview_;
  std::optional<AttemptLog> log_;
  std::uint64_t frames_shown_ = 0;
  SessionOutcome outcome_;
};

}  // namespace foveola::study
