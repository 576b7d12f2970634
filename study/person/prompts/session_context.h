// State of a session as far as its participant may know it, and its consequences for the trial.
#pragma once

#include <cstddef>
#include <optional>

#include "study/person/forms/words.h"
#include "study/session/session.h"

namespace foveola::study {

/// Everything referred to must outlive it.
struct SessionContext {
  const Protocol& protocol;
  const Plan& plan;
  const Procedure& procedure;
  const SessionState& seen;  ///< the durable state: nothing else may be seen
};

/// Returns the participant's current trial. Throws std::logic_error if there is none.
const PlannedTrial& trial_at(const SessionContext& context);

/// Counts practice trials and the others separately. trial: index into the plan.
TrialCount trial_count(const Plan& plan, std::size_t trial);

/// Returns the notice before the current trial; empty if there is none or the trial is retimed.
std::optional<Notice> notice_before_trial(const SessionContext& context);

}  // namespace foveola::study
