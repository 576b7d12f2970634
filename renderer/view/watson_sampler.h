// FV by Watson's acuity, which differs between left and right, above and below.
#pragma once

#include <array>
#include <vector>

#include "renderer/view/acuity.h"
#include "renderer/view/gaze_frame.h"
#include "renderer/view/radial_distribution.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

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
