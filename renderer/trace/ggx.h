// The GGX microfacet distribution and its visible normals.
#pragma once

#include <cmath>
#include <numbers>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

/// Below it a surface is perfectly smooth: reflections of rougher ones blur over 0.006 degrees.
constexpr float smallest_roughness = 0.01F;

/// Below this alpha, the slopes of half vectors are finer than floats near 1.
constexpr float fine_alpha = 0.01F;

/// normalize(a + b) in double. Not inline: few surfaces are so smooth that they need it.
Vec3 fine_half_vector(const Vec3& a, const Vec3& b);

/// Smith's Lambda of a direction w on either side of the surface (Heitz 2014, eq. 72). Numbers and
/// vectors, or lanes of them.
template <typename Number, typename Vector>
Number smith_lambda(const Number& alpha, const Vector& w) {
  const Number tangent_squared = (w.x * w.x + w.y * w.y) / (w.z * w.z);
  return 0.5F * (square_root(1.0F + alpha * alpha * tangent_squared) - 1.0F);
}

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

  float lambda(const Vec3& w) const { return smith_lambda(alpha, w); }

  /// The normal that reflects one direction into the other. The density hangs on its slope.
  Vec3 half_vector(const Vec3& a, const Vec3& b) const {
    return alpha < fine_alpha ? fine_half_vector(a, b) : glm::normalize(a + b);
  }

  /// A microfacet normal as seen from `w`, with density G1(w) max(0, w.n) density(n) / w.z (Dupuy
  /// and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"). u: in the unit square.
  Vec3 sample_visible_normal(const Vec3& w, const Vec2& u) const {
    const float azimuth = 2.0F * std::numbers::pi_v<float> * u.x;
    return visible_normal(w, {std::cos(azimuth), std::sin(azimuth)}, u.y);
  }

  /// The same, with the azimuth as a unit vector. u < 1.
  Vec3 visible_normal(const Vec3& w, const Vec2& azimuth, float u) const {
    const Vec3 stretched = glm::normalize(Vec3(alpha * w.x, alpha * w.y, w.z));
    // The point of the cap lies this far below the sphere's top; without the differences from 1
    // both small and large u keep their digits.
    const float depth = u * (1.0F + stretched.z);
    const float r = std::sqrt(depth * (2.0F - depth));
    return glm::normalize(Vec3(alpha * (r * azimuth.x + stretched.x),
                               alpha * (r * azimuth.y + stretched.y),
                               (1.0F - u) * (1.0F + stretched.z)));
  }
};

/// `w` mirrored at `normal`; unit length.
inline Vec3 reflected(const Vec3& w, const Vec3& normal) {
  return glm::normalize(2.0F * glm::dot(w, normal) * normal - w);
}

}  // namespace foveola
