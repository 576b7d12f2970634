// The GGX microfacet distribution and its visible normals.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/vec.h"

namespace foveola {

/// All directions are in a local frame whose +z is the surface's normal, unit length.
struct Ggx {
  float alpha = 1.0F;  ///< > 0; glTF's roughness squared

  /// Density of microfacet normals per steradian and projected area (Walter et al. 2007, eq. 33),
  /// in a form that keeps its digits at small alpha.
  float density(const Vec3& normal) const {
    const float slope = (normal.x * normal.x + normal.y * normal.y) / (alpha * alpha);
    const float s = slope + normal.z * normal.z;
    return 1.0F / (std::numbers::pi_v<float> * alpha * alpha * s * s);
  }

  /// Smith's Lambda of a direction above the surface (Heitz 2014, eq. 72).
  float lambda(const Vec3& w) const {
    const float tangent_squared = (w.x * w.x + w.y * w.y) / (w.z * w.z);
    return 0.5F * (std::sqrt(1.0F + alpha * alpha * tangent_squared) - 1.0F);
  }

  /// A microfacet normal as seen from `w`, with density G1(w) max(0, w.n) density(n) / w.z (Dupuy
  /// and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"). u: in the unit square.
  Vec3 sample_visible_normal(const Vec3& w, const Vec2& u) const {
    const float azimuth = 2.0F * std::numbers::pi_v<float> * u.x;
    return visible_normal(w, {std::cos(azimuth), std::sin(azimuth)}, u.y);
  }

  /// The same, with the azimuth as a unit vector.
  Vec3 visible_normal(const Vec3& w, const Vec2& azimuth, float u) const {
    const Vec3 stretched = glm::normalize(Vec3(alpha * w.x, alpha * w.y, w.z));
    const float z = (1.0F - u) * (1.0F + stretched.z) - stretched.z;
    const float r = std::sqrt(std::max(0.0F, 1.0F - z * z));
    const Vec3 normal = Vec3(r * azimuth.x, r * azimuth.y, z) + stretched;
    return glm::normalize(Vec3(alpha * normal.x, alpha * normal.y, normal.z));
  }
};

/// Smoother surfaces are treated as this smooth (alpha = 0.001: reflections blur over 0.1 degrees),
/// so that densities stay far from what a float can hold.
constexpr float smallest_roughness = 0.0316227766F;

/// roughness: perceptual, in [0, 1].
inline Ggx ggx_of_roughness(float roughness) {
  const float clamped = std::max(roughness, smallest_roughness);
  return {.alpha = clamped * clamped};
}

/// Whether a surface of this perceptual roughness is a perfect mirror or lens.
inline bool is_smooth(float roughness) { return roughness < 0.01F; }

/// How far Schlick's Fresnel reflectance is on its way from its value at normal incidence to 1
/// (Schlick 1994, eq. 15). cosine: in [0, 1].
inline float schlick_weight(float cosine) {
  const float complement = 1.0F - cosine;
  const float squared = complement * complement;
  return squared * squared * complement;
}

}  // namespace foveola
