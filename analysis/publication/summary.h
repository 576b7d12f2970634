// The study's main numbers for the terminal.
#pragma once

#include <string>

#include "analysis/publication/study_tables.h"

namespace foveola::analysis {

/// Several lines of aligned plain text, at their top what must be known about the data, ended by a
/// line break. Control characters in names are shown as "?".
std::string terminal_summary(const StudyTables& tables);

}  // namespace foveola::analysis
