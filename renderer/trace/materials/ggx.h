// The GGX microfacet distribution, its visible normals, and its reflection lobe.
#pragma once

#include <numbers>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/turns.h"
#include "renderer/base/vec.h"

namespace foveola {

/// Below it a surface is a perfect mirror: reflections at this roughness blur over 0.006 degrees.
constexpr float min_roughness = 0.01F;

/// Below this alpha, float cannot resolve the slopes of half vectors.
constexpr float min_float_alpha = 0.01F;

/// normalize(a + b) in double. Not inline, since few surfaces are so smooth.
Vec3 half_vector_in_double(const Vec3& a, const Vec3& b);

/// The normal that reflects one direction into the other. The density falls off over slopes of
/// about alpha, so that a small alpha needs precise slopes.
inline Vec3 half_vector(float alpha, const Vec3& a, const Vec3& b) {
  return alpha < min_float_alpha ? half_vector_in_double(a, b) : normalized(a + b);
}
/// The same for lanes, with alpha >= min_float_alpha.
inline Vec3s half_vector(const Floats& /*alpha*/, const Vec3s& a, const Vec3s& b) {
  return normalized(a + b);
}

/// Directions are in a local frame whose +z is the unit normal of the surface. Number: float, or
/// Floats.
template <typename Number>
struct GgxOf {
  using Vector = Vec3Of<Number>;

  Number alpha = Number{} + 1.0F;  ///< > 0; glTF's roughness squared

  /// Density of microfacet normals per steradian and projected area (Walter et al. 2007, eq. 33),
  /// in a form that stays precise at small alpha.
  Number density(const Vector& normal) const {
    const Number slope = (normal.x * normal.x + normal.y * normal.y) / (alpha * alpha);
    const Number s = slope + normal.z * normal.z;
    return 1.0F / (std::numbers::pi_v<float> * alpha * alpha * s * s);
  }

  /// Smith's Lambda of a direction on either side of the surface (Heitz 2014, eq. 72).
  Number lambda(const Vector& w) const {
    const Number tangent_squared = (w.x * w.x + w.y * w.y) / (w.z * w.z);
    return 0.5F * (square_root(1.0F + alpha * alpha * tangent_squared) - 1.0F);
  }

  /// A microfacet normal as seen from `w`, with density G1(w) max(0, w.n) density(n) / w.z (Dupuy
  /// and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"). u: in [0, 1).
  Vector sample_visible_normal(const Vector& w, const SinesCosines<Number>& azimuth,
                               const Number& u) const {
    const Vector stretched = normalized(Vector{alpha * w.x, alpha * w.y, w.z});
    // Depth of the cap's point below the sphere's top. Without differences from 1, small and large
    // u stay precise.
    const Number depth = u * (1.0F + stretched.z);
    const Number r = square_root(depth * (2.0F - depth));
    return normalized(Vector{alpha * (r * azimuth.cosine + stretched.x),
                             alpha * (r * azimuth.sine + stretched.y),
                             (1.0F - u) * (1.0F + stretched.z)});
  }
  /// The same with a random azimuth. u: in the unit square.
  Vector sample_visible_normal(const Vector& w, const Vec2Of<Number>& u) const {
    return sample_visible_normal(w, azimuth_at(u.x), u.y);
  }
};
using Ggx = GgxOf<float>;

/// `w` mirrored at `normal`; unit length. Vectors, or lanes of vectors.
template <typename Vector>
inline Vector reflected(const Vector& w, const Vector& normal) {
  return normalized((2.0F * dot(w, normal)) * normal - w);
}

/// Number: float, or Floats.
template <typename Number>
class MicrofacetLobeOf {
 public:
  using Vector = Vec3Of<Number>;

  /// Without a direction; assign before use.
  MicrofacetLobeOf() = default;

  /// outgoing: unit length, z > 0.
  MicrofacetLobeOf(const GgxOf<Number>& ggx, const Vector& outgoing)
      : ggx_(ggx),
        outgoing_(outgoing),
        lambda_outgoing_(ggx.lambda(outgoing)),
        masking_outgoing_(1.0F / (1.0F + lambda_outgoing_)),
        inverse_alpha_squared_(1.0F / (ggx.alpha * ggx.alpha)),
        density_scale_(4.0F * std::numbers::pi_v<float> * ggx.alpha * ggx.alpha * outgoing.z) {}

  const GgxOf<Number>& ggx() const { return ggx_; }

  struct LobeValue {
    Number times_cosine;  ///< BSDF times the incoming cosine for a Fresnel reflectance of 1
    Number pdf;           ///< per steradian, of sample()
    Number cosine;        ///< between the half vector and either direction, in [0, 1]
  };

  /// incoming: unit length, z > 0. probability: of sampling this lobe, a factor of the density.
  LobeValue eval(const Vector& incoming, const Number& probability) const {
    const Vector half = half_vector(ggx_.alpha, outgoing_, incoming);
    // Both share D / (4 cos(outgoing)), with D as in GgxOf::density(); the masking is G2 in the
    // BSDF and G1 in the density of visible normals (Heitz 2018, eq. 17). One division serves both.
    const Number s = (half.x * half.x + half.y * half.y) * inverse_alpha_squared_ + half.z * half.z;
    const Number inverse_masking = 1.0F + lambda_outgoing_ + ggx_.lambda(incoming);
    const Number times_cosine = 1.0F / (density_scale_ * s * s * inverse_masking);
    return {.times_cosine = times_cosine,
            .pdf = probability * times_cosine * inverse_masking * masking_outgoing_,
            .cosine = smaller(dot(outgoing_, half), 1.0F)};
  }

  LobeValue eval(const Vector& incoming) const { return eval(incoming, Number{} + 1.0F); }

  /// Unit length; z <= 0 if it lies below the surface. u: see GgxOf::sample_visible_normal().
  Vector sample(const SinesCosines<Number>& azimuth, const Number& u) const {
    return reflected(outgoing_, ggx_.sample_visible_normal(outgoing_, azimuth, u));
  }

 private:
  GgxOf<Number> ggx_{};
  Vector outgoing_{};
  Number lambda_outgoing_{};
  Number masking_outgoing_{};
  Number inverse_alpha_squared_{};
  Number density_scale_{};
};

/// A lobe of any roughness.
class MicrofacetLobe : public MicrofacetLobeOf<float> {
 public:
  MicrofacetLobe() = default;

  /// roughness: perceptual, in [0, 1].
  MicrofacetLobe(float roughness, const Vec3& outgoing)
      : MicrofacetLobeOf({.alpha = roughness < min_roughness ? 1.0F : roughness * roughness},
                         outgoing),
        is_smooth_(roughness < min_roughness) {}

  /// A perfect mirror, for which eval() and sample() are not defined.
  bool is_smooth() const { return is_smooth_; }

 private:
  bool is_smooth_ = true;
};

}  // namespace foveola
