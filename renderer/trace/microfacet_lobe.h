// The reflection of a GGX surface, seen from one direction.
#pragma once

#include <numbers>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/trace/ggx.h"

namespace foveola {

/// Number: float, or Floats.
template <typename Number>
class MicrofacetLobeOf {
 public:
  using Vector = Vec3Of<Number>;

  /// To be assigned to.
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

  struct Facets {
    Number times_cosine;  ///< BSDF times the incoming cosine for a Fresnel reflectance of 1
    Number pdf;           ///< per steradian, of sample()
    Number cosine;        ///< between the half vector and either direction, in [0, 1]
  };

  /// incoming: unit length, z > 0. probability: of sampling this lobe; the density has it as a
  /// factor.
  Facets facets(const Vector& incoming, const Number& probability) const {
    const Vector half = half_vector(ggx_.alpha, outgoing_, incoming);
    // Both share D / (4 cos(outgoing)), with D as in GgxOf::density(); the masking is G2 in the
    // BSDF and G1 in the density of visible normals (Heitz 2018, eq. 17). One division for both.
    const Number s = (half.x * half.x + half.y * half.y) * inverse_alpha_squared_ + half.z * half.z;
    const Number inverse_masking = 1.0F + lambda_outgoing_ + ggx_.lambda(incoming);
    const Number times_cosine = 1.0F / (density_scale_ * s * s * inverse_masking);
    return {.times_cosine = times_cosine,
            .pdf = probability * times_cosine * inverse_masking * masking_outgoing_,
            .cosine = smaller(dot(outgoing_, half), 1.0F)};
  }

  Facets facets(const Vector& incoming) const { return facets(incoming, Number{} + 1.0F); }

  /// Unit length; z <= 0 if it ends below the surface. u: see GgxOf::visible_normal().
  Vector sample(const SinesCosines<Number>& azimuth, const Number& u) const {
    return reflected(outgoing_, ggx_.visible_normal(outgoing_, azimuth, u));
  }

 private:
  GgxOf<Number> ggx_{};
  Vector outgoing_{};
  Number lambda_outgoing_{};
  Number masking_outgoing_{};
  Number inverse_alpha_squared_{};
  Number density_scale_{};
};

/// Of any roughness.
class MicrofacetLobe : public MicrofacetLobeOf<float> {
 public:
  MicrofacetLobe() = default;

  /// roughness: perceptual, in [0, 1].
  MicrofacetLobe(float roughness, const Vec3& outgoing)
      : MicrofacetLobeOf({.alpha = roughness < smallest_roughness ? 1.0F : roughness * roughness},
                         outgoing),
        is_smooth_(roughness < smallest_roughness) {}

  /// A perfect mirror, of which facets() and sample() know nothing.
  bool is_smooth() const { return is_smooth_; }

 private:
  bool is_smooth_ = true;
};

}  // namespace foveola
