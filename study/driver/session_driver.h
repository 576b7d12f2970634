// Drives a session through its procedure: feeds events to the state machine and the record, and
// carries out their effects once they are durable. The ports decide about time and participant.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "study/driver/ports.h"
#include "study/driver/session_log.h"
#include "study/driver/session_so_far.h"

namespace foveola::study {

struct DrivenSession {
  const Protocol& protocol;  ///< protocol and plan must outlive the driver
  const Plan& plan;
  SessionPosition position;  ///< where it resumes: before its end, or at an end that is undone
  std::vector<std::string> notes;  ///< written when the session begins or resumes
};

struct SessionOutcome {
  Phase phase = Phase::created;  ///< completed, refused, withdrawn, excluded or interrupted
  std::size_t trials = 0;        ///< number of trials completed in this run
  Nanoseconds duration{0};       ///< duration of this run, by the session's clock
  std::uint64_t samples = 0;     ///< samples traced in finished attempts
  std::uint64_t non_finite = 0;
};

class SessionDriver {
 public:
  /// Ports and recorder must outlive it.
  SessionDriver(DrivenSession session, const ClockPort& clock, DisplayPort& display,
                InputPort& input, SessionRecorder& recorder);

  /// Runs until a port leaves it, or `stop` is requested, which is recorded as an interruption.
  /// Rethrows the error that kept the record from being written.
  SessionOutcome run(const std::stop_token& stop);

  // Functions for the ports.

  /// Records the event and takes the session's step; its effects follow once it is durable. Returns
  /// false, and does nothing, if it is not allowed in this state.
  bool record_event(const Event& event);
  /// Handles a press of the awaited mark's key at `time`: a mark, or its time-out if it is too
  /// late. Returns whether it is a mark.
  bool mark(Nanoseconds time);
  /// Interrupts the session, waits until its events are durable, and leaves it.
  void interrupt();
  /// Ends the run: the session is over, or interrupted.
  void leave() { is_left_ = true; }

  const Procedure& procedure() const { return log_.procedure(); }
  /// State after all events, durable or not.
  const SessionState& state() const { return log_.state(); }
  /// State after the durable events: nothing else may be seen.
  const SessionState& seen() const { return seen_; }
  /// Whether effects are pending: until then nobody has seen the question of an answer.
  bool has_effects_to_come() const { return log_.has_effects_to_come(); }
  /// Whether the session waits in this phase, and shows so.
  bool waits_in(Phase phase) const { return state().phase == phase && !has_effects_to_come(); }

  /// Index in the plan of the visible trial. There must be one.
  std::size_t trial_index() const;
  const PlannedTrial& trial() const { return session_.plan[trial_index()]; }
  AttemptKey attempt_key() const { return {.trial = trial_index(), .attempt = seen_.attempt}; }
  /// Time from which the participant may rate the trial.
  Nanoseconds look_around_until() const { return look_around_until_; }
  const std::optional<GazeCorrection>& correction() const { return correction_; }

 private:
  void begin();
  void write_notes();
  /// Returns whether anything happened.
  bool take_turn();
  void follow_time();
  void show();
  Nanoseconds shown_until() const;
  void carry_out_durable();
  void carry_out(const std::vector<DurableEvent>& events);
  void carry_out(const Effect& effect);
  bool ends_attempt(const Event& event) const;
  void begin_attempt();
  void end_attempt();
  Nanoseconds deadline() const;

  DrivenSession session_;
  const ClockPort& clock_;
  DisplayPort& display_;
  InputPort& input_;
  SessionLog log_;
  SessionState seen_;
  std::optional<GazeCorrection> correction_;
  std::unique_ptr<AttemptPort> attempt_;  ///< set during an attempt
  bool is_to_render_ = false;             ///< whether an attempt is running, or is due to begin
  Nanoseconds look_around_until_{0};
  std::uint64_t events_fed_ = 0;
  SessionOutcome outcome_;
  bool is_left_ = false;
};

}  // namespace foveola::study
