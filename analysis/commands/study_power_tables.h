// Prints the power of a protocol's simulated studies for `foveola analyze --power`.
#pragma once

#include <string>
#include <vector>

#include "analysis/monte_carlo/expected_study.h"
#include "analysis/monte_carlo/study_power.h"

namespace foveola::analysis {

/// The expectations and the simulated studies.
struct StudyPowerReport {
  ExpectedStudy expected;
  double target = 0.9;  ///< Target power.
  std::size_t studies = 0;
  std::uint64_t seed = 1;
  bool from_pilot = false;  ///< Whether unstated expectations were taken from a pilot.
  std::vector<StudyPower> curve;
};

/// Returns the expectations as lines for the terminal, to print before the simulation.
std::string expectations_text(const StudyPowerReport& report);

/// Returns the power by numbers of participants, and the minimum numbers that reach the target, as
/// lines.
std::string study_power_text(const StudyPowerReport& report);

/// Returns everything as an indented JSON object.
std::string study_power_json(const StudyPowerReport& report);

}  // namespace foveola::analysis
