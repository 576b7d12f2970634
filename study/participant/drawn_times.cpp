#include "study/participant/drawn_times.h"

#include <cmath>

#include "study/participant/chance.h"

namespace foveola::study {
namespace {

/// The logarithm of the injected factor on the mark's time in this trial.
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

}  // namespace foveola::study
