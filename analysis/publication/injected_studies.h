// Studies of drawn numbers with injected effects, which the analysis must recover.
#pragma once

#include <cstdint>
#include <vector>

#include "study/record/study_records.h"

namespace foveola::analysis {

/// The model that values are drawn from: the logarithms of times are normal around scene +
/// participant + method + participant-by-method interaction; scenes and methods come in a random
/// order. Beside the published marks and rating there are a third mark, `recognition`, whose times
/// have the outline's ratios, and a rating of 0 to 100, `comfort`, that is normal around 50 +
/// participant + method.
struct InjectedEffects {
  int participants = 16;
  int scenes = 5;
  std::vector<double> ratios = {1.0, 0.32, 0.1};  ///< Median times over the first method's.
  // Standard deviations and changes are of natural logarithms.
  double speed_sd = 0.5;          ///< Between participants.
  double interaction_sd = 0.3;    ///< Of participants' own ratios between two methods.
  double trial_sd = 0.35;         ///< Between trials.
  double change_per_trial = 0.0;  ///< With each trial: learning if below zero.
  double comfort_shift = 0.0;     ///< In points, of the last method's `comfort`.
};

/// Records of complete simulated sessions. Same seed, same records.
study::StudyRecords study_with_injected_effects(const InjectedEffects& effects, std::uint64_t seed);

}  // namespace foveola::analysis
