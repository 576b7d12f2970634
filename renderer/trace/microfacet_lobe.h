// The reflection of a GGX surface, seen from one direction.
#pragma once

#include <algorithm>
#include <numbers>

#include "renderer/base/vec.h"
#include "renderer/trace/ggx.h"

namespace foveola {

class MicrofacetLobe {
 public:
  /// To be assigned to.
  MicrofacetLobe() = default;

  /// outgoing: unit length, z > 0. roughness: perceptual, in [0, 1].
  MicrofacetLobe(float roughness, const Vec3& outgoing)
      : is_smooth_(roughness < smallest_roughness),
        ggx_{.alpha = is_smooth_ ? 1.0F : roughness * roughness},
        outgoing_(outgoing),
        lambda_outgoing_(ggx_.lambda(outgoing)),
        masking_outgoing_(1.0F / (1.0F + lambda_outgoing_)),
        inverse_alpha_squared_(1.0F / (ggx_.alpha * ggx_.alpha)),
        density_scale_(4.0F * std::numbers::pi_v<float> * ggx_.alpha * ggx_.alpha * outgoing.z) {}

  /// A perfect mirror: only mirrored() tells what it does.
  bool is_smooth() const { return is_smooth_; }
  const Ggx& ggx() const { return ggx_; }

  struct Facets {
    float times_cosine;  ///< BSDF times the incoming cosine for a Fresnel reflectance of 1
    float pdf;           ///< per steradian, of sample()
    float cosine;        ///< between the half vector and either direction, in [0, 1]
  };

  /// incoming: unit length, z > 0.
  Facets facets(const Vec3& incoming) const {
    const Vec3 half = ggx_.half_vector(outgoing_, incoming);
    // Both share D / (4 cos(outgoing)), with D as in Ggx::density(); the masking is G2 in the BSDF
    // and G1 in the density of visible normals (Heitz 2018, eq. 17). One division for both.
    const float s = (half.x * half.x + half.y * half.y) * inverse_alpha_squared_ + half.z * half.z;
    const float inverse_masking = 1.0F + lambda_outgoing_ + ggx_.lambda(incoming);
    const float times_cosine = 1.0F / (density_scale_ * s * s * inverse_masking);
    return {.times_cosine = times_cosine,
            .pdf = times_cosine * inverse_masking * masking_outgoing_,
            .cosine = std::min(glm::dot(outgoing_, half), 1.0F)};
  }

  /// Unit length; z <= 0 if it ends below the surface.
  Vec3 sample(const Vec2& u) const {
    return reflected(outgoing_, ggx_.sample_visible_normal(outgoing_, u));
  }

  Vec3 mirrored() const { return {-outgoing_.x, -outgoing_.y, outgoing_.z}; }

 private:
  bool is_smooth_ = true;
  Ggx ggx_{};
  Vec3 outgoing_{0.0F};
  float lambda_outgoing_ = 0.0F;
  float masking_outgoing_ = 0.0F;
  float inverse_alpha_squared_ = 0.0F;
  float density_scale_ = 0.0F;
};

}  // namespace foveola
