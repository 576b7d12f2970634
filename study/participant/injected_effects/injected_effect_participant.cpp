#include "study/participant/injected_effects/injected_effect_participant.h"

#include <algorithm>

#include "study/participant/answers.h"
#include "study/participant/chance.h"

namespace foveola::study {

InjectedEffectParticipant::InjectedEffectParticipant(const InjectedEffect& effect,
                                                     const SimulatedParticipant& person,
                                                     const Background& background,
                                                     const ObservedSession& session)
    : SimulatedParticipant(person),
      effect_(effect),
      background_(background),
      session_(session),
      withdraws_after_(draw_dropout()) {}

std::optional<int> InjectedEffectParticipant::draw_dropout() const {
  const std::size_t trials = session_.plan.size();
  Pcg32 random = chance(session_.seed, Chance::injected_dropout);
  if (trials < 2 || random.uniform() >= effect_.dropout_part) {
    return std::nullopt;
  }
  return 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(trials - 1)));
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
  Pcg32 random = chance(session_.seed, Chance::ratings, {attempt_.conduct});
  std::vector<Answer> answers = draw_answers(ratings, background_, random);
  for (const Question& rating : ratings) {
    if (effect_.shifted_ratings.contains(rating.id)) {
      std::ranges::find(answers, rating.id, &Answer::question)->value =
          drawn_rating(effect_, rating, drawn());
    }
  }
  return answers;
}

std::optional<Nanoseconds> InjectedEffectParticipant::consider(const Evidence& /*evidence*/,
                                                               Nanoseconds now) {
  first_frame_ = first_frame_.value_or(now);
  if (!is_marking_ || planned().kind == TrialKind::catch_trial) {
    return std::nullopt;
  }
  is_marking_ = false;
  const DrawnMark mark{.index = marks_, .id = session_.marks.at(marks_)};
  ++marks_;
  const double time_s = drawn_time_s({}, effect_, drawn(), mark);
  return std::max(now, *first_frame_ + nanoseconds_from_seconds(time_s));
}

const PlannedTrial& InjectedEffectParticipant::planned() const {
  return session_.plan.at(static_cast<std::size_t>(attempt_.trials_before));
}

DrawnTrial InjectedEffectParticipant::drawn() const {
  return {.seed = session_.seed,
          .participant = session_.row + 1,
          .scene = planned().scene,
          .method = planned().method,
          .trials_before = attempt_.trials_before,
          .timing = attempt_.conduct};
}

}  // namespace foveola::study
