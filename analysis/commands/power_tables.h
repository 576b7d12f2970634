// `foveola analyze --power` without a protocol: how many participants a comparison of times needs,
// by the paired t test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace foveola::analysis {

struct PowerSettings {
  double ratio_percent = 50.0;  ///< Expected time, in per cent of the baseline's; not 100.
  double spread = 2.0;          ///< Factor by which participants' own ratios vary, above 1.
  double alpha = 0.05;          ///< Significance level of the two-sided test.
  double power = 0.9;           ///< The power to reach.
  std::optional<std::size_t> participants;  ///< If given, their power is computed instead.
  std::size_t studies = 10'000;             ///< The number of simulated studies.
  std::uint64_t seed = 1;
};

/// The result: participants, power by formula and by simulation.
struct PowerPlan {
  std::size_t participants = 0;
  double power = 0.0;
  double simulated_power = 0.0;
  double simulated_low = 0.0;
  double simulated_high = 0.0;
};

/// Throws Error if a million participants are too few, or for a ratio of 100 % or a spread of 1.
PowerPlan plan_power(const PowerSettings& settings);

/// Several lines for the terminal, ended by a line break.
std::string power_text(const PowerSettings& settings, const PowerPlan& plan);

/// A JSON object, indented.
std::string power_json(const PowerSettings& settings, const PowerPlan& plan);

}  // namespace foveola::analysis
