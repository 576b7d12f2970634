// The inverse of the foveated distribution at the speed and accuracy of a float.
#pragma once

#include <array>

#include "renderer/view/acuity.h"

namespace foveola {

/// FoveatedDistribution::eccentricity_deg in radians, within 1e-6 relative. In s = sqrt(u) the
/// eccentricity is a straight line up to the acuity's knee and smooth beyond it, where a cubic
/// through exact values and slopes stands for it.
class EccentricityTable {
 public:
  explicit EccentricityTable(const FoveatedDistribution& distribution);

  /// u in [0, 1].
  float operator()(float u) const;

 private:
  static constexpr int intervals = 256;
  struct Knot {
    float value;  ///< radians
    float slope;  ///< radians per interval
  };
  float foveal_slope_;  ///< radians per unit of s
  float knee_;          ///< s of the knee
  std::array<Knot, intervals + 1> knots_;
};

}  // namespace foveola
