// Foveated samplers (FV): by a distribution of eccentricity, by equation 7 of Koskela et al. 2018
// as printed, and by Watson's acuity, which differs between meridians.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "renderer/view/acuity.h"
#include "renderer/view/gaze_frame.h"
#include "renderer/view/radial_distribution.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

/// Equation 7 as printed, uncorrected. It approximates the inverse of Reddy's distribution to 80
/// degrees (ReddyDistribution). The radius of a uniform random number u is
///
///   18.64 sqrt(u)                                                for u <= 0.0965
///   25.09 u^4 + 0.1680 u^3 + 27.61 u^2 + 23.87 u + 3.232         beyond
///
/// in degrees. The branches do not meet: no sample falls between them. The maximum radius is 79.97.
class Equation7Distribution final : public RadialDistribution {
 public:
  /// The last u of the first branch.
  static constexpr double switch_u = 0.0965;

  /// The radius at u = 1.
  double cutoff_deg() const override { return cutoff_deg_; }
  /// The ends of the gap, a ring without samples: the radii of both branches at the switch.
  std::vector<double> knees_deg() const override { return {gap_begin_deg_, gap_end_deg_}; }
  /// The u of a radius; in the gap, switch_u.
  double cumulative(double eccentricity_deg) const override;
  double eccentricity_deg(double u) const override;
  /// Density of these radii, not of the acuity: 1 / (2 pi e p'(u)) per planar square degree, with
  /// the slope p'(u) of the radius. 0 in the gap.
  double density_per_sr(double eccentricity_deg) const override;

 private:
  static double up_to_switch_deg(double u);
  static double beyond_switch_deg(double u);

  double gap_begin_deg_ = up_to_switch_deg(switch_u);
  double gap_end_deg_ = beyond_switch_deg(switch_u);
  double cutoff_deg_ = beyond_switch_deg(1.0);
};

/// Samples a radial distribution around the gaze.
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

/// The modelled visual field: of one eye, or the mean of both.
enum class Eyes { left, right, both };

/// Between two meridians Watson (2014, eq. 9 and 10) combines their spacings like the half-axes of
/// an ellipse, and spacing is the inverse root of density: at (x, y) from the gaze, with r^2 = x^2
/// + y^2, r^2 / d = x^2 / d_x(r) + y^2 / d_y(r). In a quadrant this has a closed form: it
/// integrates over the azimuth to pi/2 sqrt(d_x d_y), and the azimuth of (sqrt(d_x) cos t,
/// sqrt(d_y) sin t) follows it for uniform t. Samples thus follow the model itself, without a
/// table's error.
class WatsonSampler final : public ViewSampler {
 public:
  /// exponent: power of the meridians' densities before they are combined; positive. cutoff_deg in
  /// (0, 180).
  WatsonSampler(Eyes eyes, double exponent, double cutoff_deg, EccentricityMeasure measure);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  static constexpr std::size_t quadrants =
      4;  ///< quadrants of an eye's field: temporal or nasal, up or down
  /// A quadrant of an eye's field, and its stripe of the unit square.
  struct Stripe {
    std::size_t quadrant;
    float sign_x;
    float begin;  ///< first y; stripes are sorted by it
    float height;
    bool is_clockwise;  ///< alternates, so that the azimuth is continuous between stripes
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
  std::vector<EccentricityTable> eccentricity_turns_;  ///< one per quadrant
  std::vector<Stripe> stripes_;
  GazeFrame gaze_;
};

}  // namespace foveola
