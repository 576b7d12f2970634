// The study's main results: the top of its report, and what the terminal prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/background.h"
#include "analysis/koskela2018/published_study.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

/// Several lines of aligned plain text, ended by a line break; the first says whether participants
/// were simulated, those below it are the headline. Control characters in names are shown as "?".
/// `results` has the tables of an analysis.
std::string terminal_summary(const StudyTables& tables, const std::vector<Table>& results,
                             const Comparisons& comparisons, const Background& background,
                             const std::optional<PublishedStudy>& published);

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
