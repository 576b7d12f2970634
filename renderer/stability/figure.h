// One line of the table of numerical stability: what was measured, and what it may be at most.
#pragma once

#include <cmath>
#include <string>

namespace foveola {

struct StabilityFigure {
  std::string name;
  double measured = 0.0;  ///< not a number if it could not be measured, which is a failure
  double bound = 0.0;     ///< the largest value that is accepted
  std::string unit;       ///< unit of both values: "%", "standard errors", "of 1000000 paths"
  std::string details;    ///< how it was measured, and where the worst case is

  bool passes() const { return measured <= bound; }
};

}  // namespace foveola
