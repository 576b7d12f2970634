#include "renderer/view/eccentricity_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"

namespace foveola {

EccentricityTable::EccentricityTable(const FoveatedDistribution& distribution) {
  const double total = distribution.cumulative(distribution.cutoff_deg());
  const double knee_deg = std::min(reddy_knee_deg, distribution.cutoff_deg());
  const double knee = std::sqrt(distribution.cumulative(knee_deg) / total);
  foveal_slope_ = static_cast<float>(radians(knee_deg) / knee);
  knee_ = static_cast<float>(knee);
  const double step = (1.0 - knee) / intervals;
  for (int i = 0; i <= intervals; ++i) {
    const double s = knee + i * step;
    const double e_deg = i == 0 ? knee_deg : distribution.eccentricity_deg(s * s);
    // Beyond the knee, so that the first slope is that of the periphery.
    const double acuity = reddy_acuity(std::nextafter(e_deg, 90.0));
    const double slope_deg = 2.0 * s * total / (2.0 * std::numbers::pi * e_deg * acuity);
    knots_[static_cast<std::size_t>(i)] = {.value = static_cast<float>(radians(e_deg)),
                                           .slope = static_cast<float>(radians(slope_deg * step))};
  }
}

float EccentricityTable::operator()(float u) const {
  const float s = std::sqrt(u);
  if (s <= knee_) {
    return s * foveal_slope_;
  }
  const float position = (s - knee_) / (1.0F - knee_) * intervals;
  const int i = std::min(static_cast<int>(position), intervals - 1);
  const float t = position - static_cast<float>(i);
  const Knot& a = knots_[static_cast<std::size_t>(i)];
  const Knot& b = knots_[static_cast<std::size_t>(i) + 1];
  // Cubic Hermite as value + t (slope + t (quadratic + t cubic)).
  const float rise = b.value - a.value;
  const float quadratic = 3.0F * rise - 2.0F * a.slope - b.slope;
  const float cubic = a.slope + b.slope - 2.0F * rise;
  return a.value + t * (a.slope + t * (quadratic + t * cubic));
}

}  // namespace foveola
