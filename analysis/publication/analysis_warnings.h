// Lists warnings that readers of an analysis need first: about its file, data and planned
// comparisons.
#pragma once

#include <string>
#include <vector>

#include "analysis/publication/analyze_study.h"

namespace foveola::analysis {

/// Returns a sentence per warning. `output` has its tables, comparisons, checks and verification.
std::vector<std::string> warnings_about(const AnalysisOutput& output);

}  // namespace foveola::analysis
