// The material model a second time, from its formulas, in double and by quadrature: the oracle that
// the tests hold against the tracer.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

struct ReferenceMaterial {
  double base = 1.0;
  double metallic = 0.0;
  double roughness = 1.0;
  double alpha() const { return roughness * roughness; }
};

inline double reference_lambda(const DVec3& w, double alpha) {
  const double tangent = std::tan(std::acos(std::min(1.0, w.z)));
  return (std::sqrt(1.0 + alpha * alpha * tangent * tangent) - 1.0) / 2.0;
}

inline double reference_schlick(double f0, double cosine) {
  return f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5.0);
}

/// Integrates (F S)(outgoing, incoming) * incoming.z * g(incoming) over the hemisphere, by the
/// midpoint rule over the normals, which are placed with density D(h) h.z.
inline double integrate_specular(double f0, double alpha, double cosine,
                                 const std::function<double(const DVec3&)>& g, int radii = 300,
                                 int azimuths = 60) {
  const DVec3 o(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
  const double lambda_o = reference_lambda(o, alpha);
  double sum = 0.0;
  for (int i = 0; i < radii; ++i) {
    // Cubed towards 1, where the steepest normals are.
    const double s = (i + 0.5) / radii;
    const double rest = (1.0 - s) * (1.0 - s) * (1.0 - s);
    const double density = 3.0 * (1.0 - s) * (1.0 - s);
    const double tangent = alpha * std::sqrt((1.0 - rest) / rest);
    const double z = 1.0 / std::sqrt(1.0 + tangent * tangent);
    for (int k = 0; k < azimuths; ++k) {
      const double azimuth = std::numbers::pi * (k + 0.5) / azimuths;
      const DVec3 h(z * tangent * std::cos(azimuth), z * tangent * std::sin(azimuth), z);
      const double oh = glm::dot(o, h);
      const DVec3 in = 2.0 * oh * h - o;
      if (oh > 0.0 && in.z > 0.0) {
        const double masking = 1.0 / (1.0 + lambda_o + reference_lambda(in, alpha));
        sum += density * reference_schlick(f0, oh) * masking * oh / (cosine * z) * g(in);
      }
    }
  }
  return sum / (radii * azimuths);
}

inline double specular_albedo(double f0, double alpha, double cosine) {
  return integrate_specular(f0, alpha, cosine, [](const DVec3&) { return 1.0; });
}

/// The coat's directional albedo for one roughness, tabulated finely, and its mean.
class ReferenceCoat {
 public:
  explicit ReferenceCoat(double alpha) {
    for (int i = 0; i <= steps; ++i) {
      const double t = std::max(1e-3, static_cast<double>(i) / steps);
      albedos_.push_back(specular_albedo(0.04, alpha, t * t));
    }
    for (int i = 0; i < 1000; ++i) {
      const double c = (i + 0.5) / 1000.0;
      mean_ += 2.0 * at(c) * c / 1000.0;
    }
  }
  double at(double cosine) const {
    const double x = std::sqrt(cosine) * steps;
    const int i = std::min(static_cast<int>(x), steps - 1);
    const auto k = static_cast<std::size_t>(i);
    return albedos_[k] + (x - i) * (albedos_[k + 1] - albedos_[k]);
  }
  double mean() const { return mean_; }

 private:
  static constexpr int steps = 100;
  std::vector<double> albedos_;
  double mean_ = 0.0;
};

/// The BSDF of the model that bsdf.h states.
inline double reference_bsdf(const ReferenceMaterial& m, const ReferenceCoat& coat, const DVec3& o,
                             const DVec3& i) {
  const double pi = std::numbers::pi;
  const double a2 = m.alpha() * m.alpha();
  const DVec3 h = glm::normalize(o + i);
  const double d = a2 / (pi * std::pow(h.z * h.z * (a2 - 1.0) + 1.0, 2.0));
  const double s = d / (4.0 * o.z * i.z) /
                   (1.0 + reference_lambda(o, m.alpha()) + reference_lambda(i, m.alpha()));
  const double cosine = glm::dot(o, h);
  const double layer =
      m.base / pi * (1.0 - coat.at(o.z)) * (1.0 - coat.at(i.z)) / (1.0 - coat.mean());
  return m.metallic * reference_schlick(m.base, cosine) * s +
         (1.0 - m.metallic) * (layer + reference_schlick(0.04, cosine) * s);
}

/// The directional albedo of the model: the Lambertian layer reflects base * (1 - E).
inline double reference_albedo(const ReferenceMaterial& m, double cosine) {
  const double coat = specular_albedo(0.04, m.alpha(), cosine);
  return m.metallic * specular_albedo(m.base, m.alpha(), cosine) +
         (1.0 - m.metallic) * (coat + m.base * (1.0 - coat));
}

}  // namespace foveola
