// What a reader of an analysis has to know first: its file, its data, its planned comparisons.
#pragma once

#include <string>
#include <vector>

#include "analysis/publication/analyze_study.h"

namespace foveola::analysis {

/// A sentence for each; `output` has its tables, comparisons, checks and verification.
std::vector<std::string> warnings_about(const AnalysisOutput& output);

}  // namespace foveola::analysis
