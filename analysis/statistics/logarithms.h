// Logarithms of times and ratios, of which their means, tests and intervals are computed.
#pragma once

#include <span>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// Logarithms of times that differ by no more than this are equal but for rounding: no clock
/// resolves a relative difference of 1e-12.
inline constexpr double rounding_of_logarithms = 1e-12;

/// The natural logarithms, in the same order. Throws Error, naming the position from 1, if a value
/// is not above zero or not finite.
std::vector<double> logarithms(std::span<const double> values);

/// An interval of logarithms as one of what they are logarithms of.
Interval exp_of(const Interval& logs);

}  // namespace foveola::analysis
