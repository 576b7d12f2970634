#include "study/participant/observer/decision.h"

#include <algorithm>
#include <cmath>

#include "study/participant/chance.h"

namespace foveola::study {
namespace {

/// Draws a factor with median 1, whose logarithm is normal with deviation `spread`.
double log_normal_factor(double spread, Pcg32& random) {
  return std::exp(spread * random.normal());
}

}  // namespace

Traits draw_traits(const Population& population, std::uint64_t seed) {
  const DecisionHabits& habits = population.decision;
  Pcg32 random = chance(seed, Chance::traits);
  Traits traits;
  traits.outline_criterion = log_normal_factor(habits.criterion_spread, random);
  traits.material_criterion = log_normal_factor(habits.criterion_spread, random);
  traits.reaction = log_normal_factor(habits.reaction_spread, random);
  traits.rating_bias = log_normal_factor(population.rating.bias_spread, random);
  traits.drift_per_trial = habits.drift_per_trial * random.normal();
  return traits;
}

Nanoseconds draw_reaction(const DecisionHabits& habits, const Traits& traits, Pcg32& random) {
  const double normal_part = habits.reaction_mean_s + habits.reaction_deviation_s * random.normal();
  const double tail = habits.reaction_tail_s * random.exponential();
  return nanoseconds_from_seconds(traits.reaction * (std::max(0.0, normal_part) + tail));
}

Decision::Decision(const DecisionHabits& habits, const Traits& traits, std::uint64_t seed)
    : habits_(habits), traits_(traits), seed_(seed) {}

void Decision::begin_attempt(const Attempt& attempt) {
  attempt_ = attempt;
  task_.reset();
  mark_ = 0;
  noticed_early_press_ = false;
}

void Decision::begin(Task task, Nanoseconds now) {
  task_ = task;
  ++mark_;
  glance_ = 0;
  begun_ = now;
  waiting_since_ = mark_ == 1 ? now : waiting_since_;
  draws_ = draw_for_mark();
}

Decision::MarkDraws Decision::draw_for_mark() const {
  Pcg32 random = chance(seed_, Chance::conduct, {attempt_.conduct, mark_});
  MarkDraws draws;
  draws.early = random.uniform() < habits_.early_part;
  draws.noticed = random.uniform() < habits_.early_noticed_part;
  draws.delay = draw_reaction(habits_, traits_, random);
  if (random.uniform() < habits_.lapse_part) {
    draws.delay += nanoseconds_from_seconds(habits_.lapse_s * random.exponential());
  }
  return draws;
}

double Decision::log_evidence(const Evidence& evidence, Nanoseconds now) const {
  const double drift = traits_.drift_per_trial * attempt_.trials_before;
  const double contentment = std::log1p(habits_.impatience_per_s * seconds(now - waiting_since_));
  const double ratio =
      *task_ == Task::mark_outline
          ? evidence.outline_signal_to_noise /
                (habits_.outline_signal_to_noise * traits_.outline_criterion)
          : habits_.material_jnd * traits_.material_criterion / evidence.material_jnd;
  return std::clamp(std::log(ratio) - drift + contentment, -habits_.evidence_limit,
                    habits_.evidence_limit);
}

std::optional<Nanoseconds> Decision::consider(const Evidence& evidence, Nanoseconds now) {
  if (!task_ || *task_ == Task::look_around) {
    return std::nullopt;
  }
  Pcg32 random = chance(seed_, Chance::glances, {attempt_.conduct, mark_, glance_});
  const double noisy = log_evidence(evidence, now) + habits_.glance_noise * random.normal();
  const double since_s = seconds(now - last_glance_);
  const double weight = glance_ == 0 || habits_.integration_s == 0.0
                            ? 1.0
                            : -std::expm1(-since_s / habits_.integration_s);
  mean_ = glance_ == 0 ? noisy : mean_ + weight * (noisy - mean_);
  ++glance_;
  last_glance_ = now;
  const double criterion = draws_.early ? -std::log(habits_.early_factor) : 0.0;
  if (mean_ < criterion || now - begun_ < nanoseconds_from_seconds(habits_.integration_s)) {
    return std::nullopt;
  }
  noticed_early_press_ = noticed_early_press_ || (draws_.early && draws_.noticed);
  task_.reset();
  return now + draws_.delay;
}

}  // namespace foveola::study
