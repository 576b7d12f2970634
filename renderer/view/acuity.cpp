#include "renderer/view/acuity.h"

#include <algorithm>

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
          .knees_deg = {inner_deg, outer_deg}};
}

}  // namespace foveola
