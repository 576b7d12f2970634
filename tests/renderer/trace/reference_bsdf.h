// The material model a second time, from the formulas of renderer/MATERIALS.md, in double and by
// quadrature: the oracle that the tests hold against the tracer. One channel of colour at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

/// The brightest channels' values say how much light the layers below get; 0 in greys.
struct ReferenceMaterial {
  double base = 1.0;
  double metallic = 0.0;
  double roughness = 1.0;
  double ior = 1.5;
  double specular = 1.0;
  double specular_colour = 1.0;
  double brightest_specular_colour = 0.0;
  double transmission = 0.0;
  bool is_solid = false;
  bool from_inside = false;
  double clearcoat = 0.0;
  double clearcoat_roughness = 0.0;
  double sheen = 0.0;
  double brightest_sheen = 0.0;
  double sheen_roughness = 0.0;

  double alpha() const { return roughness * roughness; }
  double f0() const { return f0_of(specular_colour); }
  double brightest_f0() const {
    return f0_of(std::max(specular_colour, brightest_specular_colour));
  }
  double f90() const { return ior > 1.0 ? specular : 0.0; }
  double eta() const { return from_inside ? 1.0 / ior : ior; }
  double f0_of(double colour) const {
    return std::pow((ior - 1.0) / (ior + 1.0), 2.0) * specular * colour;
  }
};

inline double reference_lambda(const DVec3& w, double alpha) {
  const double tangent = std::tan(std::acos(std::min(1.0, std::abs(w.z))));
  return (std::sqrt(1.0 + alpha * alpha * tangent * tangent) - 1.0) / 2.0;
}

/// Height-correlated.
inline double reference_masking(const DVec3& o, const DVec3& i, double alpha) {
  return 1.0 / (1.0 + reference_lambda(o, alpha) + reference_lambda(i, alpha));
}

inline double reference_ggx(const DVec3& m, double alpha) {
  const double a2 = alpha * alpha;
  return a2 / (std::numbers::pi * std::pow(m.z * m.z * (a2 - 1.0) + 1.0, 2.0));
}

inline double reference_schlick(double f0, double f90, double cosine) {
  return f0 + (f90 - f0) * std::pow(1.0 - cosine, 5.0);
}

/// Fresnel's equations, with the amplitudes in terms of both cosines.
inline double reference_fresnel(double cosine, double eta) {
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) / eta;
  if (sine >= 1.0) {
    return 1.0;
  }
  const double refracted = std::sqrt(1.0 - sine * sine);
  const double s = (cosine - eta * refracted) / (cosine + eta * refracted);
  const double p = (refracted - eta * cosine) / (refracted + eta * cosine);
  return (s * s + p * p) / 2.0;
}

/// Integrates weight(h, o.h) over the normals h that face o, by the midpoint rule; the normals are
/// placed with density D(h) h.z.
inline double integrate_normals(double alpha, const DVec3& o,
                                const std::function<double(const DVec3&, double)>& weight,
                                int radii = 300, int azimuths = 60) {
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
      if (oh > 0.0) {
        sum += density * oh / (o.z * z) * weight(h, oh);
      }
    }
  }
  return sum / (radii * azimuths);
}

inline DVec3 direction_in_plane(double cosine) {
  return {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
}

/// The albedo of F S with Schlick's F.
inline double specular_albedo(double f0, double f90, double alpha, double cosine) {
  const DVec3 o = direction_in_plane(cosine);
  return integrate_normals(alpha, o, [&](const DVec3& h, double oh) {
    const DVec3 i = 2.0 * oh * h - o;
    return i.z > 0.0 ? reference_schlick(f0, f90, oh) * reference_masking(o, i, alpha) : 0.0;
  });
}

/// The albedo of rough glass before it is scaled to 1, without eta squared.
inline double glass_albedo(double eta, double alpha, double cosine, int radii = 300,
                           int azimuths = 60) {
  const DVec3 o = direction_in_plane(cosine);
  const auto weight = [&](const DVec3& h, double oh) {
    const double fresnel = reference_fresnel(oh, eta);
    const DVec3 reflected = 2.0 * oh * h - o;
    double sum = reflected.z > 0.0 ? fresnel * reference_masking(o, reflected, alpha) : 0.0;
    if (fresnel < 1.0) {
      const double inside = std::sqrt(1.0 - (1.0 - oh * oh) / (eta * eta));
      const DVec3 refracted = (oh / eta - inside) * h - o / eta;
      sum += refracted.z < 0.0 ? (1.0 - fresnel) * reference_masking(o, refracted, alpha) : 0.0;
    }
    return sum;
  };
  return integrate_normals(alpha, o, weight, radii, azimuths);
}

/// Charlie's Lambda (Estevez and Kulla 2017, eq. 3, with both rows of table 1 mixed).
inline double reference_sheen_lambda(double cosine, double alpha) {
  const double t = (1.0 - alpha) * (1.0 - alpha);
  const auto fit = [&](double x) {
    const double a = t * 25.3245 + (1.0 - t) * 21.5473;
    const double b = t * 3.32435 + (1.0 - t) * 3.82987;
    const double c = t * 0.16801 + (1.0 - t) * 0.19823;
    const double d = t * -1.27393 + (1.0 - t) * -1.97760;
    const double e = t * -4.85967 + (1.0 - t) * -4.32054;
    return a / (1.0 + b * std::pow(x, c)) + d * x + e;
  };
  return std::exp(cosine < 0.5 ? fit(cosine) : 2.0 * fit(0.5) - fit(1.0 - cosine));
}

/// White sheen, not divided by its albedo.
inline double reference_sheen(const DVec3& o, const DVec3& i, double roughness) {
  const double alpha = std::pow(std::max(roughness, 0.07), 2.0);
  const double cosine = std::min(1.0, glm::normalize(o + i).z);
  const double d =
      (2.0 + 1.0 / alpha) * std::pow(1.0 - cosine * cosine, 0.5 / alpha) / (2.0 * std::numbers::pi);
  return d / (4.0 * o.z * i.z *
              (1.0 + reference_sheen_lambda(o.z, alpha) + reference_sheen_lambda(i.z, alpha)));
}

inline double sheen_albedo(double roughness, double cosine) {
  constexpr int rings = 200;
  constexpr int sectors = 100;
  const DVec3 o = direction_in_plane(cosine);
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    // Cubed: masking changes fastest at grazing angles.
    const double s = (i + 0.5) / rings;
    const double z = s * s * s;
    const double r = std::sqrt(1.0 - z * z);
    for (int k = 0; k < sectors; ++k) {
      const double azimuth = std::numbers::pi * (k + 0.5) / sectors;
      const DVec3 w(r * std::cos(azimuth), r * std::sin(azimuth), z);
      sum += reference_sheen(o, w, roughness) * z * 3.0 * s * s;
    }
  }
  return 2.0 * std::numbers::pi * sum / (rings * sectors);
}

/// The lobe's directional albedos for one roughness, tabulated finely, and the coat's mean.
class ReferenceCoat {
 public:
  explicit ReferenceCoat(double alpha, double f0 = 0.04, double f90 = 1.0) {
    for (int i = 0; i <= steps; ++i) {
      const double t = std::max(1e-3, static_cast<double>(i) / steps);
      white_.push_back(specular_albedo(1.0, 1.0, alpha, t * t));
      coat_.push_back(specular_albedo(f0, f90, alpha, t * t));
    }
    for (int i = 0; i < 1000; ++i) {
      const double c = (i + 0.5) / 1000.0;
      mean_ += 2.0 * at(c) * c / 1000.0;
    }
  }
  explicit ReferenceCoat(const ReferenceMaterial& m)
      : ReferenceCoat(m.alpha(), m.brightest_f0(), m.f90()) {}

  double at(double cosine) const { return interpolate(coat_, cosine); }
  double white_at(double cosine) const { return interpolate(white_, cosine); }
  double mean() const { return mean_; }

 private:
  static constexpr int steps = 100;
  static double interpolate(const std::vector<double>& albedos, double cosine) {
    const double x = std::sqrt(cosine) * steps;
    const int i = std::min(static_cast<int>(x), steps - 1);
    const auto k = static_cast<std::size_t>(i);
    return albedos[k] + (x - i) * (albedos[k + 1] - albedos[k]);
  }

  std::vector<double> white_;
  std::vector<double> coat_;
  double mean_ = 0.0;
};

/// S with a Fresnel reflectance for the half vector.
inline double reference_reflection(const DVec3& o, const DVec3& i, double alpha,
                                   const std::function<double(double)>& fresnel) {
  const DVec3 h = glm::normalize(o + i);
  return fresnel(glm::dot(o, h)) * reference_ggx(h, alpha) * reference_masking(o, i, alpha) /
         (4.0 * o.z * i.z);
}

/// Rough glass, scaled by 1 / albedo: reflection for i.z > 0, transmission of radiance for i.z < 0.
inline double reference_glass(const ReferenceMaterial& m, const DVec3& o, const DVec3& i,
                              double albedo) {
  const double eta = m.eta();
  if (i.z > 0.0) {
    return reference_reflection(o, i, m.alpha(),
                                [&](double c) { return reference_fresnel(c, eta); }) /
           albedo;
  }
  DVec3 h = glm::normalize(o + eta * i);
  h = h.z < 0.0 ? -h : h;
  const double oh = glm::dot(o, h);
  const double ih = glm::dot(i, h);
  if (oh <= 0.0 || ih >= 0.0) {
    return 0.0;
  }
  return m.base * (1.0 - reference_fresnel(oh, eta)) * reference_ggx(h, m.alpha()) *
         reference_masking(o, i, m.alpha()) * oh * -ih /
         (o.z * -i.z * std::pow(oh + eta * ih, 2.0)) / albedo;
}

/// The rough base without layers over it. glass: the albedo to divide glass by.
inline double reference_base(const ReferenceMaterial& m, const ReferenceCoat& coat, const DVec3& o,
                             const DVec3& i, double glass) {
  const double dielectric = 1.0 - m.metallic;
  const double opaque = dielectric * (1.0 - m.transmission);
  const double through = dielectric * m.transmission;
  double sum = m.is_solid && through > 0.0 ? through * reference_glass(m, o, i, glass) : 0.0;
  if (i.z < 0.0) {
    const DVec3 mirrored(i.x, i.y, -i.z);
    return m.is_solid
               ? sum
               : through * m.base * (1.0 - coat.at(o.z)) / coat.white_at(o.z) *
                     reference_reflection(o, mirrored, m.alpha(), [](double) { return 1.0; });
  }
  if (m.metallic > 0.0) {
    const double white = coat.white_at(o.z);
    sum += m.metallic * (1.0 + m.base * (1.0 - white) / white) *
           reference_reflection(o, i, m.alpha(),
                                [&](double c) { return reference_schlick(m.base, 1.0, c); });
  }
  sum += (m.is_solid ? opaque : dielectric) * reference_reflection(o, i, m.alpha(), [&](double c) {
           return reference_schlick(m.f0(), m.f90(), c);
         });
  return sum + opaque * m.base / std::numbers::pi * (1.0 - coat.at(o.z)) * (1.0 - coat.at(i.z)) /
                   (1.0 - coat.mean());
}

/// The whole BSDF. glass: as above.
inline double reference_bsdf(const ReferenceMaterial& m, const ReferenceCoat& coat, const DVec3& o,
                             const DVec3& i, double glass = 1.0) {
  double below_clearcoat = 1.0;
  double clearcoat = 0.0;
  double below_sheen = 1.0;
  double sheen = 0.0;
  if (m.clearcoat > 0.0) {
    const double alpha = m.clearcoat_roughness * m.clearcoat_roughness;
    below_clearcoat = 1.0 - m.clearcoat * specular_albedo(0.04, 1.0, alpha, o.z);
    clearcoat = m.clearcoat * reference_reflection(o, i, alpha, [](double c) {
                  return reference_schlick(0.04, 1.0, c);
                });
  }
  if (m.sheen > 0.0) {
    const double albedo = sheen_albedo(m.sheen_roughness, o.z);
    below_sheen = 1.0 - std::max(m.sheen, m.brightest_sheen) * std::min(1.0, albedo);
    sheen = m.sheen * reference_sheen(o, i, m.sheen_roughness) / std::max(1.0, albedo);
  }
  const double base = below_sheen * reference_base(m, coat, o, i, glass);
  return i.z > 0.0 ? clearcoat + below_clearcoat * (sheen + base) : below_clearcoat * base;
}

/// The directional albedo of metal and opaque dielectrics: the Lambertian layer reflects
/// base * (1 - E).
inline double reference_albedo(const ReferenceMaterial& m, double cosine) {
  const double coat = specular_albedo(m.f0(), m.f90(), m.alpha(), cosine);
  const double white = specular_albedo(1.0, 1.0, m.alpha(), cosine);
  return m.metallic * specular_albedo(m.base, 1.0, m.alpha(), cosine) *
             (1.0 + m.base * (1.0 - white) / white) +
         (1.0 - m.metallic) * (coat + m.base * (1.0 - coat));
}

}  // namespace foveola
