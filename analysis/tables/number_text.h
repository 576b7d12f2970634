// How numbers are written, the same in the report, in LaTeX, in figures and on the terminal.
#pragma once

#include <optional>
#include <string>

namespace foveola::analysis {

/// Stands where there is no value: an en dash.
inline constexpr const char* no_value = "–";

/// A value with this many decimals; no_value where there is none.
std::string fixed(std::optional<double> value, int decimals);

/// The same with its sign, "+1.5" or "-0.3"; zero has none.
std::string with_sign(std::optional<double> value, int decimals);

/// A P-value with two significant digits: "0.63", "3.2e-05"; "< 1e-300" near the smallest doubles.
std::string p_value(double p);

}  // namespace foveola::analysis
