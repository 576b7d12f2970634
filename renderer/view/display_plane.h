// How a view's pinhole and lens spread the display over the sphere: in a header, so that compilers
// work on several of a view's pixels at a time.
#pragma once

#include <cmath>

#include "renderer/base/radial_lens.h"

namespace foveola {

/// How much larger the distance from the lens' axis is than the one on the display, squared: d2.
inline double magnification(const RadialLens& lens, double d2) {
  return 1.0 + d2 * (lens.k1 + d2 * lens.k2);
}

/// How fast the distance from the lens' axis grows with the one on the display, squared: d2.
inline double growth(const RadialLens& lens, double d2) {
  return 1.0 + d2 * (3.0 * lens.k1 + d2 * 5.0 * lens.k2);
}

/// Viewport::sr_per_area, of a view with half_size() and lens().
inline double sr_per_area(const Vec2& half_size, const RadialLens& lens, const Vec2& plane) {
  const Vec2 offset = 2.0F * (plane - lens.axis) * half_size;
  const double d2 = glm::dot(offset, offset);
  const double larger = magnification(lens, d2);
  // Across the radius a patch grows by `larger`, along it by `growth`; at distance 1 it is seen
  // under its area times cos^3.
  const double area = 4.0 * half_size.x * half_size.y * larger * growth(lens, d2);
  const double cosine = 1.0 / std::sqrt(1.0 + d2 * larger * larger);
  return area * cosine * cosine * cosine;
}

}  // namespace foveola
