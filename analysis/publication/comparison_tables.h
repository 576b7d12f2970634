// The tests as files: one row per comparison, omnibus test and order effect.
#pragma once

#include <string>

#include "analysis/publication/comparisons.h"

namespace foveola::analysis {

// Each returns CSV with fixed columns that name their units; `kind` is "human", "pilot" or
// "simulated". What is not defined is an empty field.

std::string comparisons_csv(const Comparisons& comparisons, const std::string& kind);
std::string omnibus_csv(const Comparisons& comparisons, const std::string& kind);
std::string order_csv(const Comparisons& comparisons, const std::string& kind);

}  // namespace foveola::analysis
