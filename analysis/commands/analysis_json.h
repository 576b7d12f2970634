// The result of an analysis as JSON.
#pragma once

#include <string>

#include "analysis/publication/analyze_study.h"

namespace foveola::analysis {

/// The paths, the warnings and the main numbers as an indented JSON object. What does not exist is
/// null; invalid UTF-8 in texts is replaced.
std::string analysis_json(const AnalysisOutput& output);

}  // namespace foveola::analysis
