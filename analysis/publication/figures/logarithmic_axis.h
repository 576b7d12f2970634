// Logarithmic axes of the figures of times, with ticks that are plain numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

// Every value and range is above zero.

/// How far an axis reaches, with a margin: over every value, and over an interval only up to a
/// multiple of these, so that the interval of a few participants does not hide the rest. Empty
/// without values.
std::optional<Interval> reach_of(const std::vector<double>& values,
                                 const std::vector<Interval>& intervals);

/// Round numbers within the range, about five to ten of them: powers of ten over many decades, 1,
/// 2, 5, 10 and so on over a few, more multiples within one, equal steps within less.
std::vector<double> logarithmic_ticks(const Interval& range);

/// A tick's number without an exponent: "0.05", "2", "5000".
std::string plain_number(double value);

/// gnuplot's logarithmic x axis over the range, with the grid at its ticks.
std::string logarithmic_axis(const Interval& range);

/// The range with 100 per cent, which is no change, inside it.
Interval with_no_change(const Interval& percent);

/// The axes of times relative to the baseline of this label: in per cent of its time below, and
/// how many times as fast above, "1×" at 100 per cent and "2×" at 50; with the line of no change.
std::string relative_axes(const Interval& percent, const std::string& reference);

}  // namespace foveola::analysis
