// Integrals over the visible microfacet normals of a rough surface, for tables of albedos.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include "renderer/base/vec.h"
#include "renderer/trace/materials/ggx.h"

namespace foveola {

/// GGX stretched by 1/alpha is a half sphere, seen with equal density over its outline. We cut it
/// into arcs of equal y, the horizontal axis at right angles to the outgoing direction: the normals
/// (alpha rho T, alpha y sqrt(1 + T^2), rho) for all T, with rho^2 + y^2 = 1. Along an arc,
/// reflected and refracted directions cross the horizon, and total reflection sets in, at roots of
/// quadratic equations in T. Between the roots the integrands are smooth, and Gauss-Legendre
/// quadrature is nearly exact.
class VisibleNormals {
 public:
  /// outgoing: unit length, in the plane y = 0, z > 0.
  VisibleNormals(const Ggx& ggx, const Vec3& outgoing)
      : alpha_(ggx.alpha), sine_(outgoing.x), cosine_(outgoing.z) {
    const double length = std::hypot(alpha_ * sine_, cosine_);
    stretched_sine_ = alpha_ * sine_ / length;
    stretched_cosine_ = cosine_ / length;
  }

  /// Calls visit(normal, weight) for the normals that reflect above the surface. The weights of all
  /// visible normals sum to 1.
  template <typename Visit>
  void for_each_reflecting(const Visit& visit) const {
    for_each_arc([this](double k) { return reflecting(k); },
                 [&](const Arc& arc) { integrate<14>(arc, arc.range, visit); });
  }

  /// The same for normals without total reflection. eta: index of refraction of the far side over
  /// that of the near one.
  template <typename Visit>
  void for_each_transmitting(double eta, const Visit& visit) const {
    for_each_arc([&](double k) { return transmitting(k, eta); },
                 [&](const Arc& arc) {
                   const Range reflected = reflecting(arc.k);
                   const Range refracted = refracting(arc.k, eta);
                   std::array<double, 6> ends{arc.range.begin, reflected.begin, reflected.end,
                                              refracted.begin, refracted.end,   arc.range.end};
                   for (double& end : ends) {
                     end = std::clamp(end, arc.range.begin, arc.range.end);
                   }
                   std::ranges::sort(ends);
                   for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
                     integrate<10>(arc, {ends[i], ends[i + 1]}, visit);
                   }
                 });
  }

 private:
  template <unsigned points>
  using Gauss = boost::math::quadrature::gauss<double, points>;

  /// Of the parameter T.
  struct Range {
    double begin = -std::numeric_limits<double>::infinity();
    double end = std::numeric_limits<double>::infinity();
    bool empty() const { return !(begin < end); }
  };

  struct Arc {
    double y, rho, k;  ///< k = y^2 / rho^2
    double weight;
    Range range;
  };

  /// The interval where a T^2 - 2 b T + c < 0, b >= 0; beyond the greater root if a < 0.
  static Range between_roots(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (discriminant <= 0.0) {
      return {0.0, 0.0};
    }
    const double q = b + std::sqrt(discriminant);
    return {c / q, a > 0.0 ? q / a : Range().end};
  }

  /// Where the reflected direction's z is positive: 2 (o.n) n.z > o.z n.n.
  Range reflecting(double k) const {
    const double a2 = alpha_ * alpha_;
    return between_roots(cosine_ * a2 * (1.0 + k), alpha_ * sine_, cosine_ * (a2 * k - 1.0));
  }

  /// Where light is transmitted: (o.n)^2 > (1 - eta^2) n.n.
  Range transmitting(double k, double eta) const {
    if (eta >= 1.0) {
      return {};
    }
    const double a2 = alpha_ * alpha_;
    const double critical2 = (1.0 - eta) * (1.0 + eta);
    return between_roots(a2 * (critical2 * (1.0 + k) - sine_ * sine_), alpha_ * sine_ * cosine_,
                         critical2 * (1.0 + a2 * k) - cosine_ * cosine_);
  }

  /// Ends where the refracted direction may cross the horizon. Snell's law, squared to remove its
  /// root: o.z^2 n.n - 2 o.z (o.n) n.z - (eta^2 - 1) n.z^2 = 0.
  Range refracting(double k, double eta) const {
    const double a2 = alpha_ * alpha_;
    return between_roots(cosine_ * cosine_ * a2 * (1.0 + k), alpha_ * sine_ * cosine_,
                         cosine_ * cosine_ * (a2 * k - 1.0) - (eta - 1.0) * (eta + 1.0));
  }

  /// The visible part of range_of(k).
  template <typename RangeOf>
  Range visible(const RangeOf& range_of, double k) const {
    const Range range = range_of(k);
    return {std::max(range.begin, -stretched_cosine_ / stretched_sine_), range.end};
  }

  /// Calls visit_arc for the arcs, all of small y, on which range_of(k) is not empty.
  template <typename RangeOf, typename VisitArc>
  void for_each_arc(const RangeOf& range_of, const VisitArc& visit_arc) const {
    const double largest_y = largest_y_of(range_of);
    for_each_point<14>(0.0, 0.5 * std::numbers::pi, [&](double angle, double angle_weight) {
      const double y = largest_y * std::sin(angle);
      const double rho2 = (1.0 - y) * (1.0 + y);
      const double rho = std::sqrt(rho2);
      const double k = y * y / rho2;
      visit_arc(Arc{.y = y,
                    .rho = rho,
                    .k = k,
                    .weight = 4.0 / std::numbers::pi * rho / (1.0 + stretched_cosine_) * largest_y *
                              std::cos(angle) * angle_weight,
                    .range = visible(range_of, k)});
    });
  }

  template <typename RangeOf>
  double largest_y_of(const RangeOf& range_of) const {
    double inside = 0.0;
    double outside = 1.0;
    for (int i = 0; i < 30; ++i) {
      const double y = 0.5 * (inside + outside);
      (visible(range_of, y * y / ((1.0 - y) * (1.0 + y))).empty() ? outside : inside) = y;
    }
    return inside;
  }

  /// In t = tan(psi / 2) where T = tan(psi), denser towards both ends of the range: some integrands
  /// contain the square root of the distance, and the steepest normals.
  template <unsigned points, typename Visit>
  void integrate(const Arc& arc, const Range& range, const Visit& visit) const {
    if (range.empty()) {
      return;
    }
    const double begin = half_tangent(range.begin);
    const double length = half_tangent(range.end) - begin;
    for_each_point<points>(0.0, 1.0, [&](double v, double v_weight) {
      const double t = begin + length * v * v * (3.0 - 2.0 * v);
      const double t_weight = length * 6.0 * v * (1.0 - v) * v_weight;
      const double inverse = 1.0 / (1.0 + t * t);
      const double sine = 2.0 * t * inverse;
      const double cosine = (1.0 - t) * (1.0 + t) * inverse;
      const double facing = sine * stretched_sine_ + cosine * stretched_cosine_;
      const DVec3 normal(alpha_ * arc.rho * sine, alpha_ * arc.y, arc.rho * cosine);
      visit(Vec3(glm::normalize(normal)), arc.weight * facing * t_weight * 2.0 * inverse);
    });
  }

  /// tan(psi / 2) of tan(psi), which may be infinite.
  static double half_tangent(double tangent) {
    const double cotangent = 1.0 / std::abs(tangent);
    return std::copysign(1.0 / (cotangent + std::sqrt(1.0 + cotangent * cotangent)), tangent);
  }

  /// Gauss-Legendre points of an interval, with their weights.
  template <unsigned points, typename Visit>
  static void for_each_point(double begin, double end, const Visit& visit) {
    const auto& abscissas = Gauss<points>::abscissa();
    const auto& weights = Gauss<points>::weights();
    const double middle = 0.5 * (begin + end);
    const double half = 0.5 * (end - begin);
    for (std::size_t i = 0; i < abscissas.size(); ++i) {
      visit(middle - half * abscissas[i], half * weights[i]);
      visit(middle + half * abscissas[i], half * weights[i]);
    }
  }

  double alpha_;
  double sine_;
  double cosine_;
  double stretched_sine_;
  double stretched_cosine_;
};

}  // namespace foveola
