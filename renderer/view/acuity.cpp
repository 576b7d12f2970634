#include "renderer/view/acuity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace foveola {

double reddy_acuity(double eccentricity_deg) {
  if (eccentricity_deg <= reddy_knee_deg) {
    return 1.0;
  }
  const double y = 0.3 * eccentricity_deg + 1.0;
  return 7.49 / (y * y);
}

AcuityModel reddy_model() { return {.at = reddy_acuity, .knees_deg = {reddy_knee_deg}}; }

AcuityModel linear_resolution_model(double slope) {
  constexpr double smallest_angle_deg = 1.0 / 48.0;
  return {.at = [slope](double e) { return smallest_angle_deg / (smallest_angle_deg + slope * e); },
          .knees_deg = {},
          .default_exponent = 2.0};
}

AcuityModel linear_fall_off_model(double inner_deg, double outer_deg, double least) {
  return {.at =
              [=](double e) {
                const double t = (e - inner_deg) / (outer_deg - inner_deg);
                return 1.0 + (least - 1.0) * std::clamp(t, 0.0, 1.0);
              },
          .knees_deg = {inner_deg, outer_deg},
          .reach_deg = least > 0.0 ? 180.0 : outer_deg};
}

double watson_density(Meridian meridian, double eccentricity_deg) {
  struct Coefficients {
    double a;
    double r2_deg;
    double re_deg;
  };
  // In the order of Meridian, which is that of the table: temporal, superior, nasal, inferior.
  static constexpr std::array<Coefficients, 4> table{{{0.9851, 1.058, 22.14},
                                                      {0.9935, 1.035, 16.35},
                                                      {0.9729, 1.084, 7.633},
                                                      {0.996, 0.9932, 12.13}}};
  // Where the share of midget cells among ganglion cells is half of that at the gaze (eq. 7).
  constexpr double midget_scale_deg = 41.03;
  const auto& [a, r2_deg, re_deg] = table[static_cast<std::size_t>(meridian)];
  const double y = 1.0 + eccentricity_deg / r2_deg;
  return (a / (y * y) + (1.0 - a) * std::exp(-eccentricity_deg / re_deg)) /
         (1.0 + eccentricity_deg / midget_scale_deg);
}

}  // namespace foveola
