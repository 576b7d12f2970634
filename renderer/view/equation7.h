// Foveated samplers (FV): by a distribution of eccentricity, and as published, to the letter
// (equation 7 of Koskela et al. 2018).
#pragma once

#include <memory>
#include <vector>

#include "renderer/view/radial_distribution.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

/// Equation 7 as it is printed, which approximates the inverse of Reddy's distribution to 80
/// degrees (ReddyDistribution) and is not mended here: the radius of a uniform random number u is
///
///   18.64 sqrt(u)                                                for u <= 0.0965
///   25.09 u^4 + 0.1680 u^3 + 27.61 u^2 + 23.87 u + 3.232         beyond
///
/// in degrees. The two do not meet: no sample falls between the first's last radius and the
/// second's first one, and the last radius of all is 79.97.
class Equation7Distribution final : public RadialDistribution {
 public:
  /// Where the second branch takes over from the first, which still holds there.
  static constexpr double switch_u = 0.0965;

  /// The radius at u = 1.
  double cutoff_deg() const override { return cutoff_deg_; }
  /// The two ends of the ring without samples, the gap: the radius of either branch at the switch.
  std::vector<double> knees_deg() const override { return {gap_begin_deg_, gap_end_deg_}; }
  /// The u whose radius it is; in the gap that of the switch.
  double cumulative(double eccentricity_deg) const override;
  double eccentricity_deg(double u) const override;
  /// That of these radii, not of the acuity: with the slope p'(u) of the radius, 1 / (2 pi e p'(u))
  /// for each planar square degree. 0 in the gap.
  double density_per_sr(double eccentricity_deg) const override;

 private:
  static double up_to_switch_deg(double u);
  static double beyond_switch_deg(double u);

  double gap_begin_deg_ = up_to_switch_deg(switch_u);
  double gap_end_deg_ = beyond_switch_deg(switch_u);
  double cutoff_deg_ = beyond_switch_deg(1.0);
};

/// Following a distribution around the gaze.
class FoveatedSampler final : public ViewSampler {
 public:
  explicit FoveatedSampler(std::unique_ptr<RadialDistribution> distribution);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  std::unique_ptr<RadialDistribution> distribution_;
  EccentricityTable eccentricity_turns_;
  Frame around_{Vec3(0.0F, 0.0F, -1.0F)};
};

}  // namespace foveola
