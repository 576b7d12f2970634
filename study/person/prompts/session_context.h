// Where a session stands, as far as its participant may know, and what that says of the trial.
#pragma once

#include <cstddef>
#include <optional>

#include "study/person/forms/words.h"
#include "study/session/session.h"

namespace foveola::study {

/// All that it refers to must outlive it.
struct SessionContext {
  const Protocol& protocol;
  const Plan& plan;
  const Procedure& procedure;
  const SessionState& seen;  ///< what is on the disk: nothing else may be seen
};

/// The trial that the participant is in. Throws std::logic_error if there is none.
const PlannedTrial& trial_at(const SessionContext& context);

/// Practice and the others are counted by themselves. trial: index into the plan.
TrialCount trial_count(const Plan& plan, std::size_t trial);

/// What is to be said before the trial that the participant is in, if anything; nothing if it is
/// tried again.
std::optional<Notice> notice_before_trial(const SessionContext& context);

}  // namespace foveola::study
