#include "study/participant/injected_effects/drawn_trial.h"

#include <algorithm>
#include <cmath>

#include "study/participant/chance.h"

namespace foveola::study {
namespace {

/// Draws a value in (-1, 1), with a symmetric triangular density.
double triangular(Pcg32& random) {
  const double first = random.uniform();
  return first - random.uniform();
}

/// Returns the adjacent answers of the scale on both sides of `value`.
Span answers_around(const Question& rating, double value) {
  if (rating.kind != QuestionKind::choice) {
    return {.low = std::max(rating.minimum, std::floor(value)),
            .high = std::min(rating.maximum, std::floor(value) + 1.0)};
  }
  Span around = span_of(rating);
  for (const Option& option : rating.options) {
    if (*option.value <= value) {
      around.low = std::max(around.low, *option.value);
    } else {
      around.high = std::min(around.high, *option.value);
    }
  }
  return around;
}

/// Draws one of the answers around `value`, with expectation `value`.
double rounded_by_chance(const Question& rating, double value, Pcg32& random) {
  const Span around = answers_around(rating, value);
  return random.uniform() * around.width() < value - around.low ? around.high : around.low;
}

/// Returns the logarithm of the injected factor on the mark's time in this trial.
double injected_log(const InjectedEffect& effect, const DrawnTrial& trial,
                    const std::string& mark) {
  double log = std::log(effect.order_factor) * trial.trials_before;
  if (const auto faster = effect.faster.find(trial.method); faster != effect.faster.end()) {
    log -= std::log(faster->second);
  }
  if (const auto of_mark = effect.faster_marks.find(mark); of_mark != effect.faster_marks.end()) {
    const auto faster = of_mark->second.find(trial.method);
    log -= faster != of_mark->second.end() ? std::log(faster->second) : 0.0;
  }
  if (effect.outlier && effect.outlier->participant == trial.participant) {
    log += std::log(effect.outlier->slower);
  }
  return log;
}

}  // namespace

double drawn_time_s(const TimesModel& model, const InjectedEffect& effect, const DrawnTrial& trial,
                    const DrawnMark& mark) {
  const std::uint32_t scene = key_of(trial.scene);
  Pcg32 of_person = chance(trial.seed, Chance::injected_person);
  Pcg32 of_scene = chance(0, Chance::injected_scene, {scene});
  Pcg32 of_trial =
      chance(trial.seed, Chance::injected_trial, {scene, key_of(trial.method), trial.timing});
  const double log = model.participant_spread * of_person.normal() +
                     model.scene_spread * of_scene.normal() +
                     model.trial_spread * of_trial.normal() + injected_log(effect, trial, mark.id);
  return model.first_mark_s * std::pow(model.mark_ratio, static_cast<double>(mark.index)) *
         std::exp(log);
}

Span span_of(const InjectedEffect::ByMethod& shifts) {
  Span span;
  for (const auto& [method, points] : shifts) {
    span = {.low = std::min(span.low, points), .high = std::max(span.high, points)};
  }
  return span;
}

double drawn_rating(const InjectedEffect& effect, const Question& rating, const DrawnTrial& trial) {
  const InjectedEffect::ByMethod& shifts = effect.shifted_ratings.at(rating.id);
  const Span answers = span_of(rating);
  const Span shifted = span_of(shifts);
  const double free_half = 0.5 * (answers.width() - shifted.width());
  const auto shift = shifts.find(trial.method);
  const std::uint32_t key = key_of(rating.id);
  Pcg32 of_person = chance(trial.seed, Chance::injected_rating_person, {key});
  Pcg32 of_trial = chance(trial.seed, Chance::injected_rating_trial,
                          {key, key_of(trial.scene), key_of(trial.method), trial.timing});
  const double value = answers.low - shifted.low + free_half +
                       (shift != shifts.end() ? shift->second : 0.0) +
                       0.5 * free_half * (triangular(of_person) + triangular(of_trial));
  return rounded_by_chance(rating, std::clamp(value, answers.low, answers.high), of_trial);
}

}  // namespace foveola::study
