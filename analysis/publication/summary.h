// The study's main numbers for the terminal.
#pragma once

#include <optional>
#include <string>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/background.h"
#include "analysis/koskela2018/published_study.h"

namespace foveola::analysis {

/// Several lines of aligned plain text, ended by a line break; the first says whether participants
/// were simulated, those below it are the headline. Control characters in names are shown as "?".
std::string terminal_summary(const StudyTables& tables, const Comparisons& comparisons,
                             const Background& background,
                             const std::optional<PublishedStudy>& published);

}  // namespace foveola::analysis
