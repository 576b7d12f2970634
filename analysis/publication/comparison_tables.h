// The tests as files: one row per comparison, omnibus test and order effect.
#pragma once

#include <string>

#include "analysis/publication/comparisons.h"

namespace foveola::analysis {

// Each as CSV with fixed columns that name their units; `kind` is who took part. What is not
// defined is empty.

std::string comparisons_csv(const Comparisons& comparisons, const std::string& kind);
std::string omnibus_csv(const Comparisons& comparisons, const std::string& kind);
std::string order_csv(const Comparisons& comparisons, const std::string& kind);

}  // namespace foveola::analysis
