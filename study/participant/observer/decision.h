// Models the decision to press the key, by evidence that accumulates glance by glance.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/base/clock.h"
#include "renderer/base/numbers/random.h"
#include "study/participant/observer/evidence.h"
#include "study/participant/participant.h"
#include "study/participant/population.h"

namespace foveola::study {

/// Differences of one person from the population's median: factors with median 1.
struct Traits {
  double outline_criterion = 1.0;
  double material_criterion = 1.0;
  double reaction = 1.0;
  double rating_bias = 1.0;
  /// Change of the criteria's natural logarithm with each trial; above 0 they become stricter.
  double drift_per_trial = 0.0;
};
/// Draws a person's traits; equal seeds give equal persons.
Traits draw_traits(const Population& population, std::uint64_t seed);

/// Draws the reaction time of one press: ex-Gaussian (normal plus exponential), not below 0.
Nanoseconds draw_reaction(const DecisionHabits& habits, const Traits& traits, Pcg32& random);

/// A leaky integrator: the leaky mean of the logarithm of evidence is compared with a criterion.
/// Every glance's noise is a function of (seed, attempt, mark, glance), so that draws do not depend
/// on what is seen.
class Decision {
 public:
  Decision(const DecisionHabits& habits, const Traits& traits, std::uint64_t seed);

  /// Starts an attempt without a task and without a press.
  void begin_attempt(const Attempt& attempt);
  void begin(Task task, Nanoseconds now);

  /// Takes the evidence of a glance at `now`; times do not decrease. Returns the time of the key
  /// press, not before now, once per begin(); nothing while looking around.
  std::optional<Nanoseconds> consider(const Evidence& evidence, Nanoseconds now);

  /// Whether the participant noticed that a press of this attempt was early, so that the trial
  /// should be retimed.
  bool wants_retime() const { return noticed_early_press_; }

 private:
  /// The outcomes that are drawn for a mark before anything of it is seen.
  struct MarkDraws {
    bool early = false;
    bool noticed = false;
    Nanoseconds delay{0};  ///< From the decision to the press.
  };
  MarkDraws draw_for_mark() const;
  /// Natural logarithm of the evidence over its criterion at `now`, without noise.
  double log_evidence(const Evidence& evidence, Nanoseconds now) const;

  DecisionHabits habits_;
  Traits traits_;
  std::uint64_t seed_;
  Attempt attempt_;
  std::optional<Task> task_;
  std::uint32_t mark_ = 0;        ///< Number of tasks begun in this attempt.
  std::uint32_t glance_ = 0;      ///< Number of glances at this task.
  Nanoseconds waiting_since_{0};  ///< Start of the attempt's first task.
  Nanoseconds begun_{0};
  Nanoseconds last_glance_{0};
  double mean_ = 0.0;  ///< Leaky mean of the logarithm of the evidence.
  MarkDraws draws_;
  bool noticed_early_press_ = false;
};

}  // namespace foveola::study
