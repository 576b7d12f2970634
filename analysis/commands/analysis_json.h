// The result of an analysis for machines.
#pragma once

#include <string>

#include "analysis/publication/analyze_study.h"

namespace foveola::analysis {

/// The paths, the warnings and the main numbers as a JSON object, indented. What does not exist is
/// null; text that is not UTF-8 is mended.
std::string analysis_json(const AnalysisOutput& output);

}  // namespace foveola::analysis
