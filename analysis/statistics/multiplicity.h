// Adjusts P-values for the number of tests.
#pragma once

#include <span>
#include <vector>

namespace foveola::analysis {

/// Returns Holm's (1979) adjusted P-values, in the same order: each may be compared with the level
/// of the whole family.
std::vector<double> holm(std::span<const double> p_values);

}  // namespace foveola::analysis
