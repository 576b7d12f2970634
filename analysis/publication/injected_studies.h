// Studies of nothing but numbers, whose truth is known: what the analysis must find again.
#pragma once

#include <cstdint>
#include <vector>

#include "study/record/study_records.h"

namespace foveola::analysis {

/// Logarithms of times are normal around scene + participant + method + the participant's own
/// leaning to the method; scenes and methods come in a random order.
struct InjectedEffects {
  int participants = 16;
  int scenes = 5;
  std::vector<double> ratios = {1.0, 0.32, 0.1};  ///< median times over the first method's
  double speed_sd = 0.5;                          ///< between participants, in logarithms
  double leaning_sd = 0.3;                        ///< of a participant's own ratio
  double trial_sd = 0.35;
  double change_per_trial = 0.0;  ///< of the logarithm, with each trial: learning if below zero
};

/// Records of simulated sessions, complete. Same seed, same records.
study::StudyRecords study_with_injected_effects(const InjectedEffects& truth, std::uint64_t seed);

}  // namespace foveola::analysis
