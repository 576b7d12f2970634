// The findings at the top of a report: the primary result of each method's times.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"

namespace foveola::analysis {

/// A sentence in three parts, of which `value` is set apart in print.
struct Headline {
  std::string before;  ///< "FV took"
  std::string value;   ///< "59.4 [52.1, 67.7] %"
  std::string after;   ///< What it is of, the analysis, its scenes and its right-censored times.

  std::string sentence() const { return before + " " + value + " " + after; }
};

/// For each method but the baseline and each mark: the primary estimate of the ratio to the
/// baseline, by whatever analysis the plan has, or why there is none.
std::vector<Headline> headlines(const StudyTables& tables, const Comparisons& comparisons);

}  // namespace foveola::analysis
