// A study's main numbers in short: how long the baseline took, and the other methods in per cent of
// it.
#pragma once

#include <string>
#include <vector>

#include "study/record/study_records.h"

namespace foveola::study {

struct MethodMean {
  std::string mark;  ///< the mark's id
  std::string method;
  int pairs = 0;            ///< trials of the baseline and the method with one person and one scene
  double baseline_s = 0.0;  ///< geometric mean; 0 without pairs
  double percent = 0.0;     ///< geometric mean of the ratios; 0 without pairs
};

/// For each mark, each method but the first, which is the baseline. Trials that a time-out cut off
/// are left out, and what they would be compared with.
std::vector<MethodMean> method_means(const StudyRecords& records);

}  // namespace foveola::study
