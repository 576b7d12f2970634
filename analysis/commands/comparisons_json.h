// The tests of methods against methods, for machines.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "analysis/publication/comparisons.h"

namespace foveola::analysis {

/// An array with an object for each comparison; what is not defined is null.
nlohmann::ordered_json comparisons_json(const Comparisons& comparisons, const std::string& kind);

/// An array with an object for each measure.
nlohmann::ordered_json omnibus_json(const Comparisons& comparisons, const std::string& kind);

/// Whether times change along the session; a change without a test is null.
nlohmann::ordered_json order_json(const Comparisons& comparisons, const std::string& kind);

}  // namespace foveola::analysis
