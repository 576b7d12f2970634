// Drives a session through its procedure, in whatever time and before whomever: feeds events to the
// state machine and to the record, and lets them have their effects once they are on the disk.
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
  SessionPosition position;        ///< where it goes on: before its end, or at one that is undone
  std::vector<std::string> notes;  ///< written when the session begins or goes on
};

struct SessionOutcome {
  Phase phase = Phase::created;  ///< completed, refused, withdrawn, excluded or interrupted
  std::size_t trials = 0;        ///< how many were completed in this run
  Nanoseconds duration{0};       ///< how long this run took, by the session's clock
  std::uint64_t samples = 0;     ///< samples traced in the attempts that are over
  std::uint64_t non_finite = 0;
};

class SessionDriver {
 public:
  /// Ports and recorder must outlive it.
  SessionDriver(DrivenSession session, const ClockPort& clock, DisplayPort& display,
                InputPort& input, SessionRecorder& recorder);

  /// Drives it until a port leaves it, or `stop` is requested: then it is recorded as interrupted.
  /// Rethrows what kept the record from being written.
  SessionOutcome run(const std::stop_token& stop);

  // What the ports may ask and do.

  /// Records the event and takes the session's step; its effects come once it is on the disk.
  /// Returns false, and does nothing, if it is not allowed in this state.
  bool feed(const Event& event);
  /// The key for the mark that is waited for went down at `time`: a mark, or its time-out if it
  /// came too late. Returns whether it is a mark.
  bool mark(Nanoseconds time);
  /// Interrupts the session, whose last events then are on the disk, and leaves it.
  void interrupt();
  /// Nothing more is to be shown: the session is over, or interrupted.
  void leave() { is_left_ = true; }

  const Procedure& procedure() const { return log_.procedure(); }
  /// After all that was fed, on the disk or not.
  const SessionState& state() const { return log_.state(); }
  /// What is on the disk: nothing else may be seen.
  const SessionState& seen() const { return seen_; }
  /// Whether effects are still to come: until then nobody has seen what an answer would be to.
  bool has_effects_to_come() const { return log_.has_effects_to_come(); }
  /// Whether the session waits for something in this phase, and that has been seen.
  bool waits_in(Phase phase) const { return state().phase == phase && !has_effects_to_come(); }

  /// The trial that is seen; index into the plan. There must be one.
  std::size_t trial_index() const;
  const PlannedTrial& trial() const { return session_.plan[trial_index()]; }
  AttemptKey attempt_key() const { return {.trial = trial_index(), .attempt = seen_.attempt}; }
  /// When the participant has looked around for long enough to rate the trial.
  Nanoseconds look_around_until() const { return look_around_until_; }
  /// What the gaze goes through.
  const std::optional<GazeCorrection>& correction() const { return correction_; }

 private:
  void begin();
  void write_notes();
  /// Returns whether anything happened.
  bool act();
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
  std::unique_ptr<AttemptPort> attempt_;  ///< while an attempt goes on
  bool is_to_render_ = false;             ///< whether an attempt goes on, or waits to begin
  Nanoseconds look_around_until_{0};
  std::uint64_t events_fed_ = 0;
  SessionOutcome outcome_;
  bool is_left_ = false;
};

}  // namespace foveola::study
