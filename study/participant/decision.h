// From what is seen, glance by glance, to a press of the key.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/base/clock.h"
#include "renderer/base/random.h"
#include "study/participant/evidence.h"
#include "study/participant/participant.h"
#include "study/participant/population.h"

namespace foveola::study {

/// What makes a person of a population's habits: factors, 1 in the median.
struct Traits {
  double outline_criterion = 1.0;
  double material_criterion = 1.0;
  double reaction = 1.0;
  double rating_bias = 1.0;
  double drift_per_trial = 0.0;  ///< of the criteria's natural logarithm; above 0: ever stricter
};
/// Same seed, same person.
Traits draw_traits(const Population& population, std::uint64_t seed);

/// Of one press: normal plus exponential, not below 0.
Nanoseconds draw_reaction(const DecisionHabits& habits, const Traits& traits, Pcg32& random);

/// The leaky mean of the logarithm of evidence is held against a criterion; every glance's noise is
/// a function of (seed, attempt, mark, glance), so that what is drawn does not depend on what is
/// seen.
class Decision {
 public:
  Decision(const DecisionHabits& habits, const Traits& traits, std::uint64_t seed);

  /// Another attempt, or what comes after one: nothing is to be decided, nothing was pressed.
  void begin_attempt(const Attempt& attempt);
  void begin(Task task, Nanoseconds now);

  /// A glance at `now`, of the task that was begun; times do not go back. Returns the time of the
  /// key press, not before now, once; afterwards nothing, until the next begin(). Nothing while
  /// looking around.
  std::optional<Nanoseconds> consider(const Evidence& evidence, Nanoseconds now);

  /// Whether a press of this attempt was early and noticed to be so: the trial should be timed
  /// again.
  bool wants_retime() const { return regrets_; }

 private:
  /// What is drawn for a mark before anything of it is seen.
  struct Conduct {
    bool early = false;
    bool noticed = false;
    Nanoseconds delay{0};  ///< from the decision to the press
  };
  Conduct draw_conduct() const;
  /// The natural logarithm of the evidence over its criterion, without noise.
  double log_evidence(const Evidence& evidence) const;

  DecisionHabits habits_;
  Traits traits_;
  std::uint64_t seed_;
  Attempt attempt_;
  std::optional<Task> task_;
  std::uint32_t mark_ = 0;    ///< how many tasks were begun in this attempt
  std::uint32_t glance_ = 0;  ///< how many glances at this task
  Nanoseconds begun_{0};
  Nanoseconds last_glance_{0};
  double mean_ = 0.0;  ///< leaky, of the logarithm of the evidence
  Conduct conduct_;
  bool regrets_ = false;
};

}  // namespace foveola::study
