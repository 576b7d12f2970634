// How well people see away from the gaze, and the sample density that follows from it.
#pragma once

#include "renderer/base/vec.h"

namespace foveola {

/// The eccentricity up to which Reddy's acuity is 1.
inline constexpr double reddy_knee_deg = 5.79;

/// Reddy's relative visual acuity at an eccentricity (Reddy 2001, "Perceptually optimized 3D
/// graphics", as eq. 1 of Koskela et al. 2018): 1 up to 5.79 degrees, 7.49 / (0.3 e + 1)^2 beyond.
double reddy_acuity(double eccentricity_deg);

/// The published foveated density: eccentricity e in [0, cut-off] with probability density
/// proportional to 2 pi e m(e) per degree, m being Reddy's acuity (Koskela et al. 2018, eq. 3),
/// azimuth around the gaze uniform.
class FoveatedDistribution {
 public:
  explicit FoveatedDistribution(double cutoff_deg = 80.0);

  double cutoff_deg() const { return cutoff_deg_; }
  /// The integral of 2 pi e m(e) de over [0, eccentricity_deg]; the normaliser H at the cut-off is
  /// 1091.85 for 80 degrees.
  double cumulative(double eccentricity_deg) const;
  /// The exact inverse: the eccentricity in degrees below which a fraction u in [0, 1] of the
  /// samples lie.
  double eccentricity_deg(double u) const;
  /// Samples per steradian at an eccentricity, of one sample in all; 0 beyond the cut-off.
  double density_per_sr(double eccentricity_deg) const;

 private:
  double cutoff_deg_;
  double total_;
};

}  // namespace foveola
