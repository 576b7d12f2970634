// Logarithmic axes of the figures of times, with plain numbers as ticks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

// Every value and range is above zero.

/// Returns the range of an axis, with a margin: all values, and intervals only up to a multiple of
/// the values, so that a few participants' interval does not hide the rest. Empty without values.
std::optional<Interval> reach_of(const std::vector<double>& values,
                                 const std::vector<Interval>& intervals);

/// Returns about five to ten round numbers within the range: powers of ten over many decades, 1, 2,
/// 5, 10 and so on over a few, more multiples within one decade, equal steps within less.
std::vector<double> logarithmic_ticks(const Interval& range);

/// Returns a tick's number without an exponent: "0.05", "2", "5000".
std::string plain_number(double value);

/// Returns gnuplot's logarithmic x axis over the range, with the grid at its ticks.
std::string logarithmic_axis(const Interval& range);

/// Extends the range to include 100 per cent, no change.
Interval with_no_change(const Interval& percent);

/// Returns the axes of times relative to the baseline with this label. Below: per cent of its time.
/// Above: speed-up, "1×" at 100 per cent and "2×" at 50. With the line of no change.
std::string relative_axes(const Interval& percent, const std::string& reference);

}  // namespace foveola::analysis
