// Friedman's test: the same participants under several conditions, by ranks alone.
#pragma once

#include <cstddef>
#include <optional>

#include "analysis/statistics/repeated_measures.h"

namespace foveola::analysis {

struct FriedmanTest {
  std::size_t participants = 0;
  std::size_t conditions = 0;
  double chi_squared = 0.0;  ///< Corrected for ties within participants.
  double degrees_of_freedom = 0.0;
  double p = 0.0;           ///< From the chi-squared approximation.
  double kendalls_w = 0.0;  ///< Agreement of the participants, 0 to 1.
};

/// Empty with fewer than two participants, whose agreement is what is tested, or two conditions, or
/// where every participant's values are all equal.
std::optional<FriedmanTest> friedman(const RepeatedMeasures& data);

}  // namespace foveola::analysis
