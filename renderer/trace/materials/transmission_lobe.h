// Transmission lobes: thin walls and solid glass.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/ggx.h"

namespace foveola {

/// Value and sampling density of a transmitted direction, per steradian.
struct TransmissionValue {
  float times_cosine = 0.0F;  ///< for a colourless surface
  float pdf = 0.0F;
};

/// A wall without thickness: transmitted light leaves in the reflected direction, mirrored to the
/// other side. Scaled so that all entering light is transmitted.
class ThinWall {
 public:
  /// outgoing: unit length, z > 0. albedo: of the GGX lobe for a Fresnel reflectance of 1.
  ThinWall(const Ggx& ggx, const Vec3& outgoing, float albedo)
      : ggx_(ggx), outgoing_(outgoing), lambda_(ggx.lambda(outgoing)), scale_(1.0F / albedo) {}

  /// incoming: unit length, z < 0.
  TransmissionValue eval(const Vec3& incoming) const;
  /// Unit length; z >= 0 if it is not transmitted.
  Vec3 sample(const Vec2& u) const;

 private:
  Ggx ggx_;
  Vec3 outgoing_;
  float lambda_;
  float scale_;
};

/// The interface of a solid (Walter et al. 2007, "Microfacet Models for Refraction through Rough
/// Surfaces"), with height-correlated masking, scaled to an albedo of 1.
class GlassInterface {
 public:
  /// outgoing: unit length, z > 0. eta: index of refraction of the far side over the near one, > 0.
  /// albedo: unscaled, reflected plus transmitted share of the power.
  GlassInterface(const Ggx& ggx, const Vec3& outgoing, float eta, float albedo)
      : ggx_(ggx),
        outgoing_(outgoing),
        eta_(eta),
        lambda_(ggx.lambda(outgoing)),
        scale_(1.0F / albedo) {}

  float eta() const { return eta_; }
  /// The factor that makes the lobe's albedo 1.
  float scale() const { return scale_; }
  float reflectance(float cosine) const { return fresnel_split(cosine, eta_).reflected; }

  /// Factor of transmission from importance to radiance: radiance is compressed in the denser side.
  float radiance_scale() const { return 1.0F / (eta_ * eta_); }

  /// For transmission only. incoming: unit length, z < 0. The density includes the choice between
  /// reflection and transmission.
  TransmissionValue eval(const Vec3& incoming) const;

  /// The direction refracted by a microfacet; z >= 0 if it is not transmitted. Zero if the facet
  /// reflects totally.
  Vec3 refracted(const Vec3& normal) const;

 private:
  Ggx ggx_;
  Vec3 outgoing_;
  float eta_;
  float lambda_;
  float scale_;
};

}  // namespace foveola
