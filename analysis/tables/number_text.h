// Formats numbers, the same in the report, in LaTeX, in figures and on the terminal.
#pragma once

#include <optional>
#include <string>

namespace foveola::analysis {

/// Placeholder of a missing value: an en dash.
inline constexpr const char* no_value = "–";

/// Returns a value with this many decimals; no_value if there is none.
std::string fixed(std::optional<double> value, int decimals);

/// As fixed, with a sign, "+1.5" or "-0.3"; zero has none.
std::string with_sign(std::optional<double> value, int decimals);

/// Returns a P-value with two significant digits: "0.63", "3.2e-05"; "< 1e-300" near the smallest
/// doubles.
std::string p_value(double p);

}  // namespace foveola::analysis
