// The comparisons of methods as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "analysis/publication/comparisons.h"

namespace foveola::analysis {

/// An array with an object for each comparison; what is not defined is null.
nlohmann::ordered_json comparisons_json(const Comparisons& comparisons, const std::string& kind);

/// An array with an object for each measure.
nlohmann::ordered_json omnibus_json(const Comparisons& comparisons, const std::string& kind);

/// An array with the test of whether times change along the session for each mark and way of
/// counting; null where it is not defined.
nlohmann::ordered_json order_json(const Comparisons& comparisons, const std::string& kind);

}  // namespace foveola::analysis
