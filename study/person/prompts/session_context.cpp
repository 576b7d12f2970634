#include "study/person/prompts/session_context.h"

#include <stdexcept>
#include <string>

namespace foveola::study {
namespace {

bool is_practice(const PlannedTrial& trial) { return trial.kind == TrialKind::practice; }

std::size_t index_of_trial(const SessionContext& context) {
  const std::optional<std::size_t> index = trial_of(context.procedure, context.seen);
  if (!index) {
    throw std::logic_error(std::string("no trial belongs to the phase ") +
                           name_of(context.seen.phase));
  }
  return *index;
}

}  // namespace

const PlannedTrial& trial_at(const SessionContext& context) {
  return context.plan[index_of_trial(context)];
}

TrialCount trial_count(const Plan& plan, std::size_t trial) {
  // Participants must not know of catch trials, which are counted like other trials.
  TrialCount count{.trial = 0, .trials = 0};
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const bool counts = is_practice(plan[i]) == is_practice(plan[trial]);
    count.trials += counts ? 1 : 0;
    count.trial += counts && i <= trial ? 1 : 0;
  }
  return count;
}

std::optional<Notice> notice_before_trial(const SessionContext& context) {
  if (context.seen.attempt > 1) {
    return std::nullopt;
  }
  const std::size_t index = index_of_trial(context);
  const PlannedTrial& trial = context.plan[index];
  if (index == 0) {
    return is_practice(trial) ? std::optional(Notice::practice) : std::nullopt;
  }
  const PlannedTrial& before = context.plan[index - 1];
  if (is_practice(before) && !is_practice(trial)) {
    return Notice::first_trial;
  }
  return before.scene != trial.scene ? std::optional(Notice::next_scene) : std::nullopt;
}

}  // namespace foveola::study
