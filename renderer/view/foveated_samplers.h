// Foveated samplers (FV): by a distribution of eccentricity, as published to the letter (equation 7
// of Koskela et al. 2018), and by Watson's acuity, which differs between left and right, above and
// below.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "renderer/view/acuity.h"
#include "renderer/view/gaze_frame.h"
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

/// Whose visual field: one eye's, or the mean of both.
enum class Eyes { left, right, both };

/// Between two meridians Watson (2014, eq. 9 and 10) combines their spacings like the half-axes of
/// an ellipse, and spacing is the inverse root of density: at (x, y) from the gaze, with
/// r^2 = x^2 + y^2, r^2 / d = x^2 / d_x(r) + y^2 / d_y(r). In a quadrant this has a closed form: it
/// integrates over the azimuth to pi/2 sqrt(d_x d_y), and an azimuth follows it if it is that of
/// (sqrt(d_x) cos t, sqrt(d_y) sin t) with t uniform. So samples follow the model itself, and no
/// table of it has to be fine enough.
class WatsonSampler final : public ViewSampler {
 public:
  /// exponent: to which the meridians' densities are raised before they are combined; positive.
  /// cutoff_deg in (0, 180).
  WatsonSampler(Eyes eyes, double exponent, double cutoff_deg, EccentricityMeasure measure);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  static constexpr std::size_t quadrants =
      4;  ///< quadrants of an eye's field: towards temple or nose, up or down
  /// Where a quadrant of an eye's field lies around the gaze, and its part of the unit square.
  struct Stripe {
    std::size_t quadrant;
    float sign_x;
    float begin;  ///< where it begins in y; stripes are sorted by it
    float height;
    bool is_clockwise;  ///< so that the azimuth goes on where a stripe ends
  };

  double meridian_density(Meridian meridian, double eccentricity_deg) const;
  /// One eye's density relative to that at the gaze, at the unit vector (x, y) from it.
  double eye_density(double towards_temple, double up, double eccentricity_deg) const;
  void add_eye(bool is_right, double first, double share);
  Vec3 local_direction(const Vec2& point) const;

  Eyes eyes_;
  double exponent_;
  double cutoff_deg_;
  EccentricityMeasure measure_;
  double total_ = 0.0;  ///< integral of an eye's density over its field, in square degrees
  std::array<double, quadrants> shares_{};
  std::vector<EccentricityTable> eccentricity_turns_;  ///< one a quadrant
  std::vector<Stripe> stripes_;
  GazeFrame gaze_;
};

}  // namespace foveola
