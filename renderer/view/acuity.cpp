#include "renderer/view/acuity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/special_functions/lambert_w.hpp>

#include "renderer/base/angles.h"

namespace foveola {
namespace {

constexpr double pi = std::numbers::pi;

// Reddy's constants as the paper prints them: beyond the knee the acuity falls as
// scale / (slope e + 1)^2.
constexpr double scale = 7.49;
constexpr double slope_per_deg = 0.3;

constexpr double foveal_integral = pi * reddy_knee_deg * reddy_knee_deg;
constexpr double peripheral_factor = 2.0 * pi * scale / (slope_per_deg * slope_per_deg);

/// With y = slope e + 1, the integral of e / y^2 de is (ln y + 1 / y) / slope^2.
double log_plus_reciprocal(double eccentricity_deg) {
  const double y = slope_per_deg * eccentricity_deg + 1.0;
  return std::log(y) + 1.0 / y;
}

}  // namespace

double reddy_acuity(double eccentricity_deg) {
  if (eccentricity_deg <= reddy_knee_deg) {
    return 1.0;
  }
  const double y = slope_per_deg * eccentricity_deg + 1.0;
  return scale / (y * y);
}

FoveatedDistribution::FoveatedDistribution(double cutoff_deg)
    : cutoff_deg_(cutoff_deg), total_(cumulative(cutoff_deg)) {}

double FoveatedDistribution::cumulative(double eccentricity_deg) const {
  const double e = std::clamp(eccentricity_deg, 0.0, cutoff_deg_);
  if (e <= reddy_knee_deg) {
    return pi * e * e;
  }
  return foveal_integral +
         peripheral_factor * (log_plus_reciprocal(e) - log_plus_reciprocal(reddy_knee_deg));
}

double FoveatedDistribution::eccentricity_deg(double u) const {
  const double integral = u * total_;
  if (integral <= foveal_integral) {
    return std::sqrt(integral / pi);
  }
  // ln y + 1 / y = c has the solution y = -1 / W0(-exp(-c)) for y > 1, where the principal branch
  // of Lambert's W holds since then -1 / y > -1.
  const double c =
      (integral - foveal_integral) / peripheral_factor + log_plus_reciprocal(reddy_knee_deg);
  const double y = -1.0 / boost::math::lambert_w0(-std::exp(-c));
  return std::min((y - 1.0) / slope_per_deg, cutoff_deg_);
}

double FoveatedDistribution::density_per_sr(double eccentricity_deg) const {
  if (eccentricity_deg > cutoff_deg_) {
    return 0.0;
  }
  // 2 pi e m per degree and total, spread over the ring of 2 pi sin(e) steradians per radian.
  const double e_rad = radians(eccentricity_deg);
  const double e_over_sine = e_rad > 1e-8 ? e_rad / std::sin(e_rad) : 1.0;
  return reddy_acuity(eccentricity_deg) * e_over_sine * degrees(1.0) * degrees(1.0) / total_;
}

}  // namespace foveola
