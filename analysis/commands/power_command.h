// `foveola analyze --power`: planning a study instead of analysing one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/commands/power_tables.h"
#include "analysis/monte_carlo/expectations.h"

namespace foveola::analysis {

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
