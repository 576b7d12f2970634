// Smooth ways through points, for pens in the plane and for tubes in space.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "scenes/modelling/shapes.h"

namespace foveola::scenes {

/// A curve through the points (Catmull and Rom 1974) in `steps` steps from each to the next.
template <typename Point>
std::vector<Point> curve(const std::vector<Point>& points, int steps) {
  const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
  const auto at = [&](std::ptrdiff_t i) {
    return points[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
  };
  std::vector<Point> result = {points.front()};
  for (std::ptrdiff_t i = 0; i < last; ++i) {
    const Point a = at(i - 1);
    const Point b = at(i);
    const Point c = at(i + 1);
    const Point d = at(i + 2);
    for (int step = 1; step <= steps; ++step) {
      const double t = static_cast<double>(step) / steps;
      result.push_back(0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                              t * t * t * (3.0 * b - a - 3.0 * c + d)));
    }
  }
  return result;
}

inline std::vector<DVec3> curve(const std::vector<DVec3>& points, int steps) {
  return curve<DVec3>(points, steps);
}

}  // namespace foveola::scenes
