// Simulates a participant with an injected effect: drawn times and ratings, whatever the display
// shows, with ordinary eye movements.
#pragma once

#include "study/participant/injected_effects/drawn_trial.h"
#include "study/participant/injected_effects/injected_effect.h"
#include "study/participant/make_observer.h"
#include "study/participant/simulated_participant.h"

namespace foveola::study {

class InjectedEffectParticipant final : public SimulatedParticipant {
 public:
  /// `person` answers forms, chooses objects and moves the eyes. The session's plan has each
  /// trial's scene and method.
  InjectedEffectParticipant(const InjectedEffect& effect, const SimulatedParticipant& person,
                            const Background& background, const ObservedSession& session);

  void begin_attempt(const Attempt& attempt) override;
  void begin(Task task, Nanoseconds now) override;
  std::optional<Nanoseconds> see(const Stimulus& stimulus) override {
    return consider({}, stimulus.presented);
  }
  bool wants_retime() const override { return false; }
  /// True with the effect's probability, from some trial after the first on.
  bool wants_to_withdraw(int trials_before) const override;
  /// Draws the ratings that the effect shifts by its model, others like the answers to a form.
  std::vector<Answer> rate(const std::vector<Question>& ratings) override;

  /// The first glance of an attempt counts as its first frame. Catch trials have no marks.
  std::optional<Nanoseconds> consider(const Evidence& evidence, Nanoseconds now) override;

 private:
  /// Number of trials before withdrawing; empty for a participant who stays.
  std::optional<int> draw_dropout() const;

  const PlannedTrial& planned() const;
  DrawnTrial drawn() const;

  InjectedEffect effect_;
  Background background_;
  ObservedSession session_;
  std::optional<int> withdraws_after_;
  Attempt attempt_;
  std::optional<Nanoseconds> first_frame_;
  bool is_marking_ = false;
  std::size_t marks_ = 0;  ///< Number of marks made in this attempt.
};

}  // namespace foveola::study
