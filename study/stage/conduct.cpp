#include "study/stage/conduct.h"

#include <algorithm>

#include "renderer/base/error.h"
#include "study/participant/judged_measures.h"

namespace foveola::study {

Task task_of(const MarkEntry& mark) { return judgement_of(mark).value_or(Task::mark_material); }

Attempt attempt_at_trial(const SessionSeed& seed, const Protocol& protocol,
                         const Procedure& procedure, const Plan& plan, const SessionState& state) {
  const std::size_t trial = trial_of(procedure, state).value();
  return {.conduct = trial_seed(seed, SeedPurpose::conduct, protocol, plan[trial], state.timing),
          .trials_before = static_cast<int>(trial)};
}

const OfferedObject& object_named(const std::vector<OfferedObject>& offered,
                                  const std::string& name) {
  const auto found = std::find_if(offered.begin(), offered.end(),
                                  [&](const OfferedObject& object) { return object.name == name; });
  if (found == offered.end()) {
    throw Error(name, "is not among the scene's objects any more",
                "go on with the scene as it was");
  }
  return *found;
}

}  // namespace foveola::study
