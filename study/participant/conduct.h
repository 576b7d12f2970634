// Decides the actions of simulated participants, in virtual time and in real time alike.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "study/participant/participant.h"
#include "study/protocol/protocol.h"
#include "study/stage/seeds.h"

namespace foveola::study {

/// Interval between looks. It is about the eye's integration time, and each look costs as much as
/// tracing several frames.
constexpr double glance_interval_s = 0.1;

/// Time until a participant is ready for a trial: head and eye have turned to the object.
constexpr double settling_s = 1.0;

/// Passes a simulated participant's actions to the session: fed to its driver at once, or typed as
/// keys. A phase's action may be called frame after frame until the phase is over.
class ParticipantActions {
 public:
  virtual ~ParticipantActions() = default;

  /// Returns the participant, once no thread is using it.
  virtual Participant& participant() = 0;

  virtual void consent() = 0;
  virtual void hand_in(const Questionnaire& form, const std::vector<Answer>& answers) = 0;
  /// attempt: the look at all targets.
  virtual void validate_gaze(const Attempt& attempt) = 0;
  /// conduct: the number of the reaction.
  virtual void react(std::uint32_t conduct) = 0;
  /// Ends the session between two trials.
  virtual void withdraw() = 0;
  /// Called once for an attempt at a trial, before its object is chosen or it is started.
  virtual void begin_attempt(const Attempt& attempt) = 0;
  virtual void choose_object() = 0;
  virtual void start_trial() = 0;
  virtual void ask_for_retime() = 0;
  /// Called once for a task of an attempt, before the participant looks.
  virtual void begin_task(Task task) = 0;
  virtual void look_for_mark() = 0;
  virtual void look_around() = 0;
  virtual void rate() = 0;
  /// Continues after a pause.
  virtual void resume() = 0;
  /// Leaves the finished session.
  virtual void leave() = 0;
};

/// State of a session when its participant acts.
struct SessionMoment {
  const Procedure& procedure;
  const SessionState& state;
  Nanoseconds now{0};                ///< session clock
  Nanoseconds look_around_until{0};  ///< session clock: earliest time of the rating
};

/// Chooses a simulated participant's action in each phase of a session.
class SimulatedConduct {
 public:
  /// protocol, plan: must outlive this.
  SimulatedConduct(const Protocol& protocol, const Plan& plan, const SessionSeed& seed)
      : protocol_(protocol), plan_(plan), seed_(seed) {}

  /// Performs the action that the session waits for, if any.
  void perform_action(const SessionMoment& moment, ParticipantActions& actions);

 private:
  /// Trial (index into the plan) and attempt.
  using AttemptOfTrial = std::pair<std::size_t, int>;
  using TaskOfAttempt = std::pair<AttemptOfTrial, std::size_t>;

  AttemptOfTrial attempt_in(const SessionMoment& moment) const;
  /// Begins the trial's attempt unless it has begun. Returns false if the participant withdraws.
  bool enter_attempt(const SessionMoment& moment, ParticipantActions& actions);
  /// Begins the `index`-th task of the attempt unless it has begun. Returns false if the
  /// participant asks to retime the trial.
  bool enter_task(Task task, std::size_t index, const SessionMoment& moment,
                  ParticipantActions& actions);
  /// Whether the participant made the last mark and noticed that it was too early.
  bool regrets_last_mark(const SessionMoment& moment, ParticipantActions& actions) const;
  const PlannedTrial& trial_in(const SessionMoment& moment) const {
    return plan_[attempt_in(moment).first];
  }

  const Protocol& protocol_;
  const Plan& plan_;
  SessionSeed seed_;
  std::optional<AttemptOfTrial> attempt_;
  std::optional<TaskOfAttempt>
      task_;  ///< number: the mark's index, or the count of marks for the rating
};

}  // namespace foveola::study
