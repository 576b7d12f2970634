// The controller of a simulated session: it waits for what the session waits for, records each
// event, and only then lets it have its effects.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "renderer/base/clock.h"
#include "study/commands/trial_attempt.h"
#include "study/design/plan.h"
#include "study/participant/participant.h"
#include "study/record/study_store.h"
#include "study/session/session.h"
#include "study/stage/scene_stage.h"
#include "study/stage/seeds.h"

namespace foveola::study {

/// What a session needs and does not own.
struct SessionSetting {
  const Protocol& protocol;
  const SceneStages& stages;
  SessionRecorder& recorder;
  MakeAttempt make_attempt;
  SessionSeed seed;
  /// Called when a trial begins, with its index.
  std::function<void(std::size_t trial)> on_trial;
  std::stop_token stop;
};

struct SessionOutcome {
  Phase phase = Phase::created;  ///< completed, refused, withdrawn or interrupted
  std::size_t trials = 0;        ///< completed in this run
  Nanoseconds duration{0};       ///< of this run, session clock
  std::uint64_t samples = 0;
  std::uint64_t non_finite = 0;
};

/// Runs one session in virtual time, from its start or from where it broke off, until it is
/// completed, refused by the protocol's gate, withdrawn from, or interrupted because a stop was
/// requested.
class SessionRunner {
 public:
  SessionRunner(const SessionSetting& setting, const Plan& plan, Participant& participant);

  /// Before run(): goes to where what happened so far leaves the session, which is not over, and
  /// resumes it there. Throws Error if one of the events does not follow from those before.
  void resume_after(const std::vector<LoggedEvent>& events);

  SessionOutcome run();

 private:
  // What the session waits for, as an event; a stop request comes first.
  Event next_event();
  Event answer_questionnaire();
  Event validate();
  Event press();
  Event choose_object();
  Event start_trial();
  Event present_first_frame();
  Event wait_for_mark();
  Event rate();

  /// Records the event and takes the session's step. Returns what is to be done now.
  std::vector<Effect> record(const Event& event);
  /// Likewise, and does it.
  void feed(const Event& event);
  void carry_out(const Effect& effect);
  void start_rendering();
  void stop_rendering();

  /// Begins an attempt: its clock starts anew.
  void begin_attempt(const Attempt& attempt);
  void begin(Task task);
  /// Presents what is next, at most until there is something at `until`, by the attempt's clock.
  void show(Nanoseconds until);

  Nanoseconds now() const { return attempt_start_ + clock_.now(); }
  std::size_t trial_index() const { return *trial_of(procedure_, state_); }
  int trials_before() const { return static_cast<int>(trial_index()); }
  const PlannedTrial& trial() const { return plan_[trial_index()]; }
  const SceneStage& stage() const { return *setting_.stages.at(trial().scene); }
  /// The seed for `purpose` in this timing of the trial.
  std::uint32_t seed_of_trial(SeedPurpose purpose) const;
  /// The seed for `purpose` the next time that this step is tried.
  std::uint32_t seed_of_step(SeedPurpose purpose) const;

  SessionSetting setting_;
  const Plan& plan_;
  Procedure procedure_;
  Participant& participant_;
  /// The session's clock is at attempt_start_ when the attempt's, clock_, is at 0. What a
  /// participant sees and does is a matter of the latter, to the last bit.
  Nanoseconds attempt_start_{0};
  VirtualClock clock_;
  SessionState state_;
  std::optional<GazeCorrection> correction_;
  std::optional<Nanoseconds> pressed_;     ///< the key, by the attempt's clock, for the task
  std::unique_ptr<TrialAttempt> attempt_;  ///< while a trial is rendered
  SessionOutcome outcome_;
};

}  // namespace foveola::study
