// `foveola analyze --power` of a protocol: what is printed of its simulated studies.
#pragma once

#include <string>
#include <vector>

#include "analysis/monte_carlo/expected_study.h"
#include "analysis/monte_carlo/study_power.h"

namespace foveola::analysis {

/// What was expected and simulated.
struct StudyPowerReport {
  ExpectedStudy expected;
  double target = 0.9;  ///< The power to reach.
  std::size_t studies = 0;
  std::uint64_t seed = 1;
  bool from_pilot = false;  ///< Whether what is not stated was taken from a pilot.
  std::vector<StudyPower> curve;
};

/// What is expected, as lines for the terminal: before the simulation begins.
std::string expectations_text(const StudyPowerReport& report);

/// The power by numbers of participants and the fewest that reach the target, as lines.
std::string study_power_text(const StudyPowerReport& report);

/// All of it as a JSON object, indented.
std::string study_power_json(const StudyPowerReport& report);

}  // namespace foveola::analysis
