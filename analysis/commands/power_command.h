// Plans a study: `foveola analyze --power`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/monte_carlo/expectations.h"

namespace foveola::analysis {

struct PowerSettings {
  double ratio_percent = 50.0;  ///< Expected time, in per cent of the baseline's; not 100.
  double spread = 2.0;          ///< Geometric standard deviation of participants' ratios, above 1.
  double alpha = 0.05;          ///< Significance level of the two-sided test.
  double power = 0.9;           ///< Target power.
  std::optional<std::size_t> participants;  ///< If given, their power is computed instead.
  std::size_t studies = 10'000;             ///< The number of simulated studies.
  std::uint64_t seed = 1;
};

/// Planned participants, with their power by formula and by simulation.
struct PowerPlan {
  std::size_t participants = 0;
  double power = 0.0;
  double simulated_power = 0.0;
  double simulated_low = 0.0;
  double simulated_high = 0.0;
};

/// Throws Error if a million participants are too few, or for a ratio of 100 % or a spread of 1.
PowerPlan plan_power(const PowerSettings& settings);

/// Returns lines for the terminal, ended by a line break.
std::string power_text(const PowerSettings& settings, const PowerPlan& plan);

/// Returns an indented JSON object.
std::string power_json(const PowerSettings& settings, const PowerPlan& plan);

struct PowerArguments {
  bool asked = false;
  PowerSettings one_comparison;  ///< Without a protocol.
  std::string protocol;
  Expectations expectations;
  std::vector<std::string> effects;  ///< As parse_expectation reads them.
  std::optional<double> spread;
  std::optional<std::size_t> studies;
  std::size_t most_participants = 256;
  std::filesystem::path pilot;  ///< A study's file; empty without one.
  bool r = false;
  bool json = false;
};

void add_power_options(CLI::App& command, PowerArguments& arguments);

/// Prints the plan.
void run_power(const PowerArguments& arguments, const std::stop_token& stop);

}  // namespace foveola::analysis
