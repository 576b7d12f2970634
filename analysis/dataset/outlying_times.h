// Single times that stand out from what their participant, scene and method let one expect.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"

namespace foveola::analysis {

struct OutlyingTime {
  std::string mark;  ///< Its id.
  std::string participant;
  std::string scene;
  std::string method;
  double seconds = 0.0;
  double times_expected = 1.0;  ///< How many times the time that was expected.
  double studentized = 0.0;     ///< Its studentized residual when it was taken out.
};

/// The residual_outliers of log times, mark by mark, the farthest first. They stay in all results:
/// whoever leaves one out needs a reason that is not its value.
std::vector<OutlyingTime> outlying_times(const Dataset& set);

}  // namespace foveola::analysis
