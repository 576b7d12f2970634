// Summarises the study's main results for the top of its report and for the terminal.
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

/// Returns lines of aligned plain text, ended by a line break. The first says whether participants
/// were simulated, the next are the headlines. Control characters in names are shown as "?".
/// `results`: an analysis's tables.
std::string terminal_summary(const StudyTables& tables, const std::vector<Table>& results,
                             const Comparisons& comparisons, const Background& background,
                             const std::optional<PublishedStudy>& published);

/// A sentence in three parts, whose `value` is highlighted in print.
struct Headline {
  std::string before;  ///< "FV took"
  std::string value;   ///< "59.4 [52.1, 67.7] %"
  std::string after;   ///< The quantity, the analysis, its scenes and its right-censored times.

  std::string sentence() const { return before + " " + value + " " + after; }
};

/// Returns, for each mark and each method but the baseline, the planned analysis's estimate of the
/// ratio to the baseline, or the reason why there is none.
std::vector<Headline> headlines(const StudyTables& tables, const Comparisons& comparisons);

}  // namespace foveola::analysis
