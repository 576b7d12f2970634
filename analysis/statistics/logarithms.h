// Logarithms of times and ratios, on which means, tests and intervals of them stand.
#pragma once

#include <span>
#include <vector>

namespace foveola::analysis {

/// The natural logarithms, in the same order. Throws Error, naming the position from 1, if a value
/// is not above zero or not finite.
std::vector<double> logarithms(std::span<const double> values);

}  // namespace foveola::analysis
