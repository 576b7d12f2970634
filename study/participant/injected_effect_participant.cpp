#include "study/participant/injected_effect_participant.h"

#include <algorithm>

#include "study/participant/answers.h"
#include "study/participant/chance.h"

namespace foveola::study {

InjectedEffectParticipant::InjectedEffectParticipant(const InjectedEffect& effect,
                                                     const SimulatedParticipant& person,
                                                     const Background& background,
                                                     std::uint64_t seed, int row, const Plan& plan)
    : SimulatedParticipant(person),
      effect_(effect),
      background_(background),
      seed_(seed),
      row_(row),
      plan_(plan),
      withdraws_after_(draw_dropout()) {}

std::optional<int> InjectedEffectParticipant::draw_dropout() const {
  Pcg32 random = chance(seed_, Chance::injected_dropout);
  if (plan_.size() < 2 || random.uniform() >= effect_.dropout_part) {
    return std::nullopt;
  }
  return 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(plan_.size() - 1)));
}

void InjectedEffectParticipant::begin_attempt(const Attempt& attempt) {
  attempt_ = attempt;
  first_frame_.reset();
  is_marking_ = false;
  marks_ = 0;
  SimulatedParticipant::begin_attempt(attempt);
}

void InjectedEffectParticipant::begin(Task task, Nanoseconds now) {
  is_marking_ = task != Task::look_around;
  SimulatedParticipant::begin(task, now);
}

bool InjectedEffectParticipant::wants_to_withdraw(int trials_before) const {
  return withdraws_after_ && trials_before >= *withdraws_after_;
}

std::vector<Answer> InjectedEffectParticipant::rate(const std::vector<Question>& ratings) {
  Pcg32 random = chance(seed_, Chance::ratings, {attempt_.conduct});
  return draw_answers(ratings, background_, random);
}

std::optional<Nanoseconds> InjectedEffectParticipant::consider(const Evidence& /*evidence*/,
                                                               Nanoseconds now) {
  first_frame_ = first_frame_.value_or(now);
  const PlannedTrial& shown = plan_.at(static_cast<std::size_t>(attempt_.trials_before));
  if (!is_marking_ || shown.kind == TrialKind::catch_trial) {
    return std::nullopt;
  }
  is_marking_ = false;
  const DrawnTrial trial{.seed = seed_,
                         .participant = row_ + 1,
                         .scene = shown.scene,
                         .method = shown.method,
                         .trials_before = attempt_.trials_before,
                         .timing = attempt_.conduct};
  const double time_s = drawn_time_s({}, effect_, trial, marks_++);
  return std::max(now, *first_frame_ + nanoseconds_from_seconds(time_s));
}

}  // namespace foveola::study
