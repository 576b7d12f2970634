// The BSDF: glTF's metallic-roughness model and its extensions at one point.
#pragma once

#include <optional>

#include "renderer/base/vec.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/cover_layers.h"
#include "renderer/trace/materials/ggx.h"
#include "renderer/trace/materials/opaque_layers.h"
#include "renderer/trace/materials/scattering_tables.h"
#include "renderer/trace/materials/transmission_lobe.h"

namespace foveola {

/// The model of renderer/MATERIALS.md for one outgoing direction.
///
/// Directions are local: +z is the shading normal, on the side of the outgoing direction, and all
/// of them point away from the surface.
class Bsdf {
 public:
  /// outgoing: unit length, z > 0. tables: of a scene with such a material; must outlive this
  /// object. coat_normal: of the clear coat, unit length, on the side of the outgoing direction.
  Bsdf(const Reflectance& reflectance, const Vec3& outgoing, const ScatteringTables& tables,
       const Vec3& coat_normal = {0.0F, 0.0F, 1.0F});

  /// incoming: unit length, from the side that is_reflected names. Beyond the shading normal's
  /// horizon only a clear coat with another normal has a value. Perfect mirrors and lenses have no
  /// value.
  BsdfValue eval(const Vec3& incoming, bool is_reflected) const;
  /// The same on the shading normal's side.
  BsdfValue eval(const Vec3& incoming) const { return eval(incoming, incoming.z > 0.0F); }

  /// Share of light that passes a smooth thin wall straight, as a specular sample with incoming =
  /// -outgoing.
  Rgb straight_transmission() const;

  /// nullopt if the sample is lost: it ended on the wrong side of the surface. u_lobe in [0, 1), u
  /// in the unit square, both below 1.
  std::optional<BsdfSample> sample(float u_lobe, const Vec2& u) const;

 private:
  void set_layers(const Reflectance& reflectance, const ScatteringTables& tables,
                  const Vec3& coat_normal);
  void add_transmission(const Reflectance& reflectance, const ScatteringTables& tables);
  float choose_probabilities(float specular_albedo, float diffuse_albedo);
  BsdfValue eval_reflection(const Vec3& incoming) const;
  BsdfValue eval_transmission(const Vec3& incoming) const;
  std::optional<BsdfSample> sample_base(float u_lobe, const Vec2& u) const;
  std::optional<BsdfSample> sample_glass(float u_fresnel, const Vec2& u) const;
  std::optional<BsdfSample> sample_clearcoat(const Vec2& u) const;
  std::optional<BsdfSample> reflection(const Vec3& incoming) const;
  std::optional<BsdfSample> weighed(const Vec3& incoming, bool is_reflected) const;
  BsdfSample specular(const Vec3& incoming, const Rgb& share, float probability) const;

  Vec3 mirrored() const { return {-outgoing_.x, -outgoing_.y, outgoing_.z}; }

  Vec3 outgoing_;
  OpaqueLayersOf<float> layers_;
  MicrofacetLobe microfacets_;  ///< absent if the surface is only diffuse
  std::optional<ThinWall> wall_;
  std::optional<GlassInterface> glass_;
  bool is_glass_smooth_ = false;
  float glass_share_ = 0.0F;  ///< the glass's share of the mixture
  Rgb transmitted_{0.0F};  ///< mixture share and tint of light transmitted by thin walls or glass
  std::optional<CoverLayers> covers_;
  // Probabilities of the lobes given that the base is sampled, and of the base.
  float specular_probability_ = 0.0F;
  float diffuse_probability_ = 0.0F;
  float transmission_probability_ = 0.0F;
  float base_probability_ = 1.0F;
  float base_scale_ = 1.0F;  ///< share of light that the covers leave for the base
};

}  // namespace foveola
