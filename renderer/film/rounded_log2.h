// Logarithms of many numbers, faster than the library's, and the same in float.
#pragma once

#include <span>

namespace foveola {

/// Sets each of `logs` to static_cast<float>(std::log2(number)), to the bit, for a library whose
/// log2 is right within 1e-12. numbers: positive and normal, as many as logs.
void rounded_log2(std::span<const double> numbers, std::span<float> logs);

}  // namespace foveola
