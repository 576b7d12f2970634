#include "scenes/studio_car/body_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <span>

#include "renderer/base/angles.h"

namespace foveola::scenes::car {
namespace {

double square(double x) { return x * x; }

double bell(double x) { return std::exp(-x * x); }

/// max(0, x), bent over a width of `softness`.
double soft_positive(double x, double softness) {
  return 0.5 * (x + std::sqrt(x * x + softness * softness));
}

/// The larger of two distances, rounded where they differ by less than `radius` (Quilez's cubic
/// polynomial).
double smooth_max(double a, double b, double radius) {
  const double overlap = std::max(0.0, radius - std::abs(a - b)) / radius;
  return std::max(a, b) + overlap * overlap * overlap * radius / 6.0;
}

double smooth_min(double a, double b, double radius) { return -smooth_max(-a, -b, radius); }

/// A curve y(x) through points of falling x, without overshoot (Fritsch and Carlson 1980, with the
/// harmonic mean of neighbouring slopes).
double through(std::span<const DVec2> points, double x) {
  const auto slope = [&](std::size_t i) {
    return (points[i + 1].y - points[i].y) / (points[i + 1].x - points[i].x);
  };
  const auto tangent = [&](std::size_t i) {
    if (i == 0 || i + 1 == points.size()) {
      return slope(i == 0 ? 0 : i - 1);
    }
    const double before = slope(i - 1);
    const double after = slope(i);
    return before * after <= 0.0 ? 0.0 : 2.0 * before * after / (before + after);
  };
  std::size_t i = 0;
  while (i + 2 < points.size() && x < points[i + 1].x) {
    ++i;
  }
  const double width = points[i + 1].x - points[i].x;
  const double t = (x - points[i].x) / width;
  if (t < 0.0 || t > 1.0) {
    return t < 0.0 ? points[i].y + tangent(i) * (x - points[i].x)
                   : points[i + 1].y + tangent(i + 1) * (x - points[i + 1].x);
  }
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * points[i].y + (t3 - 2.0 * t2 + t) * width * tangent(i) +
         (3.0 * t2 - 2.0 * t3) * points[i + 1].y + (t3 - t2) * width * tangent(i + 1);
}

constexpr std::array<DVec2, 10> deck_line = {{{2.3, 0.63},
                                              {2.0, 0.72},
                                              {1.7, 0.785},
                                              {1.36, 0.838},
                                              {0.9, 0.895},
                                              {0.3, 0.925},
                                              {-0.6, 0.945},
                                              {-1.4, 0.975},
                                              {-1.9, 0.985},
                                              {-2.3, 0.965}}};

constexpr std::array<DVec2, 12> roof_line = {{{1.3, 0.74},
                                              {1.05, 0.865},
                                              {0.85, 0.975},
                                              {0.6, 1.09},
                                              {0.35, 1.187},
                                              {0.1, 1.25},
                                              {-0.25, 1.282},
                                              {-0.6, 1.272},
                                              {-1.0, 1.21},
                                              {-1.4, 1.1},
                                              {-1.75, 0.99},
                                              {-2.1, 0.86}}};

/// Half the lower body's width at a height: a shoulder crease, hollow doors, sills tucked under,
/// and lips around the wheel arches.
double half_width_at(double x, double y) {
  const double crease_height = 0.715 + 0.02 * (0.4 - x) / 2.0;
  double width = 0.868 - 0.34 * soft_positive(y - crease_height, 0.016);
  width += 0.035 * (y - 0.5) * bell((x - 0.1) / 1.2);
  width -= 0.5 * square(std::max(0.0, 0.42 - y));
  width -= 0.028 * bell((y - 0.45) / 0.1) * bell(square((x - 0.05) / 0.75));
  for (const double axle : {front_axle, rear_axle}) {
    const double from_axle = std::hypot(x - axle, y - wheel_radius);
    width += 0.03 * bell((from_axle - wheel_arch_radius) / 0.085);
  }
  width += 0.022 * bell((x - rear_axle) / 0.5) * bell((y - 0.76) / 0.14);
  return width - 0.05 * square(std::max(0.0, std::abs(x) - 1.3));
}

double distance_to_nose(const DVec3& p) {
  double nose = 2.2 - 0.27 * std::pow(std::abs(p.z) / 0.9, 2.4);
  nose -= 0.75 * square(std::max(0.0, p.y - 0.5));
  nose -= 1.2 * square(std::max(0.0, 0.36 - p.y));
  nose += 0.018 * bell((p.y - 0.27) / 0.05);
  return p.x - nose;
}

double distance_to_tail(const DVec3& p) {
  double tail = 2.17 - 0.2 * std::pow(std::abs(p.z) / 0.9, 2.6);
  tail += 0.045 * bell((p.y - 0.965) / 0.07);
  tail += 0.03 * bell((p.y - 0.5) / 0.12);
  tail -= 0.06 * bell((p.y - 0.76) / 0.16);
  tail -= 1.4 * square(std::max(0.0, 0.4 - p.y));
  return -p.x - tail;
}

double distance_to_lower_body(const DVec3& p) {
  const double z = std::abs(p.z);
  double deck = through(deck_line, p.x) - 0.055 * square(z / 0.8);
  deck += 0.02 * bell((z - 0.68) / 0.12) * bell((p.x - front_axle) / 0.5);
  deck += 0.012 * bell(square((p.x - 1.25) / 0.75)) * (1.0 - soft_positive(z - 0.3, 0.03) / 0.1) *
          bell(square(z / 0.42));
  double distance = smooth_max(z - half_width_at(p.x, p.y), p.y - deck, 0.16);
  distance = smooth_max(distance, distance_to_nose(p), 0.2);
  distance = smooth_max(distance, distance_to_tail(p), 0.16);
  return smooth_max(distance, 0.15 - p.y, 0.08);
}

double distance_to_cabin(const DVec3& p) {
  const double z = std::abs(p.z);
  const double wrap = 0.24 * z * z * std::clamp((p.x + 0.25) / 0.7, -1.0, 1.0);
  const double roof = through(roof_line, p.x + wrap) - 0.045 * square(z / 0.6);
  const double rear_narrowing = 0.09 * square(std::max(0.0, -0.3 - p.x));
  const double width = 0.79 - 0.42 * (p.y - 0.92) - rear_narrowing;
  return smooth_max(0.85 * (p.y - roof), z - width, 0.13);
}

DVec3 gradient(const DVec3& p) {
  constexpr double step = 1e-4;
  const auto slope = [&](const DVec3& offset) {
    return (distance_to_skin(p + offset) - distance_to_skin(p - offset)) / (2.0 * step);
  };
  return {slope({step, 0.0, 0.0}), slope({0.0, step, 0.0}), slope({0.0, 0.0, step})};
}

/// From `origin`, outside, along `direction` to the skin.
DVec3 first_on_skin(DVec3 origin, const DVec3& direction) {
  constexpr int most_steps = 120;
  for (int i = 0; i < most_steps; ++i) {
    const double distance = distance_to_skin(origin);
    origin += 0.75 * distance * direction;
    if (std::abs(distance) < 1e-9) {
      break;
    }
  }
  return origin;
}

}  // namespace

double distance_to_skin(const DVec3& p) {
  return smooth_min(distance_to_lower_body(p), distance_to_cabin(p), 0.05);
}

DVec3 skin_normal(const DVec3& p) { return glm::normalize(gradient(p)); }

DVec3 on_skin(DVec3 p, double depth) {
  constexpr int steps = 4;
  for (int i = 0; i < steps; ++i) {
    const DVec3 uphill = gradient(p);
    p -= distance_to_skin(p) / glm::dot(uphill, uphill) * uphill;
  }
  return depth == 0.0 ? p : p - depth * skin_normal(p);
}

DVec3 seen_from_side(double x, double y) { return first_on_skin({x, y, 1.1}, {0, 0, -1}); }

DVec3 seen_from_above(double x, double z) { return first_on_skin({x, 1.5, z}, {0, -1, 0}); }

DVec3 seen_from_around(double axis_x, double angle_deg, double y) {
  const double angle = radians(angle_deg);
  const DVec3 outwards(std::cos(angle), 0.0, std::sin(angle));
  return first_on_skin(DVec3(axis_x, y, 0.0) + 1.6 * outwards, -outwards);
}

}  // namespace foveola::scenes::car
