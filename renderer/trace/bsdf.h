// How a surface scatters light: glTF's metallic-roughness model at one point.
#pragma once

#include <optional>

#include "renderer/base/vec.h"
#include "renderer/trace/coat_albedo.h"
#include "renderer/trace/ggx.h"

namespace foveola {

/// A material's values at one point, textures included.
struct Reflectance {
  Rgb base_color{1.0F};  ///< linear, in [0, 1]
  float metallic = 0.0F;
  float roughness = 1.0F;     ///< perceptual, in [0, 1]
  float ior = 1.5F;           ///< >= 1
  float specular = 1.0F;      ///< in [0, 1]
  Rgb specular_color{1.0F};   ///< >= 0
  float transmission = 0.0F;  ///< in [0, 1]
  bool is_solid = false;      ///< what is transmitted is refracted; else the wall is thin
  bool from_inside = false;   ///< the outgoing direction lies in the solid
  float clearcoat = 0.0F;     ///< in [0, 1]
  float clearcoat_roughness = 0.0F;
  Rgb sheen_color{0.0F};  ///< in [0, 1]
  float sheen_roughness = 0.0F;
};

struct BsdfSample {
  Vec3 incoming;  ///< unit length, local; z < 0: transmitted
  Rgb weight;     ///< BSDF times |cosine| over pdf
  float pdf;      ///< per steradian; of a specular sample the probability
  /// The direction is the only one of a perfect mirror or lens: eval() knows nothing of it.
  bool is_specular = false;
  /// How much transmission has scaled the radiance: eta^2 when refracted (MATERIALS.md), else 1.
  /// Roulette takes it out again.
  float radiance_scale = 1.0F;
};

/// The BSDF and its sampling density, which share nearly all of their terms.
struct BsdfValue {
  Rgb times_cosine{0.0F};  ///< BSDF times the incoming direction's cosine
  float pdf = 0.0F;        ///< per steradian, with which sample() gives that direction
};

/// The model of glTF 2.0, Appendix B, seen from one direction:
///   metallic * F(base_color) S + (1 - metallic) * (base_color * L + F(0.04) S)
/// where S is the GGX microfacet lobe with height-correlated Smith masking (alpha = roughness
/// squared), F Schlick's Fresnel at the half vector, and L a Lambertian layer that gets the light
/// which the coat above it does not reflect. glTF's sample code gives that layer 1 - F; at grazing
/// angles the sum then exceeds 1. Here the layer gets (1 - E(outgoing)) (1 - E(incoming)) /
/// (1 - mean E) with the coat's directional albedo E (Kelemen and Szirmay-Kalos 2001, section 3.2):
/// reciprocal, and a white dielectric reflects exactly all light.
///
/// Directions are local: +z is the shading normal, and all of them point away from the surface.
class Bsdf {
 public:
  /// outgoing: unit length, z > 0. coat must outlive this object.
  Bsdf(const Reflectance& reflectance, const Vec3& outgoing, const CoatAlbedo& coat);

  BsdfValue eval(const Vec3& incoming) const;

  /// The share of light that passes a smooth thin wall straight on, as a specular sample with
  /// incoming = -outgoing.
  Rgb straight_transmission() const { return Rgb(0.0F); }

  /// Empty if the lobe's sample ends below the surface. u_lobe in [0, 1), u in the unit square.
  std::optional<BsdfSample> sample(float u_lobe, const Vec2& u) const;

 private:
  Vec3 outgoing_;
  Ggx ggx_;
  float lambda_outgoing_;
  CoatAlbedo::Row coat_;
  Rgb specular_f0_;  ///< of the metal and the coat, mixed
  Rgb diffuse_;      ///< the Lambertian layer's BSDF but for (1 - E(incoming))
  float specular_probability_;
};

}  // namespace foveola
