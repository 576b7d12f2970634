// What lies over a surface: clearcoat, and sheen below it.
#pragma once

#include <optional>

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/ggx.h"
#include "renderer/trace/materials/scattering_tables.h"
#include "renderer/trace/materials/sheen.h"

namespace foveola {

/// Both layers let through to what is below the share of light that they do not reflect, by their
/// albedo for the outgoing direction.
class CoverLayers {
 public:
  /// outgoing: unit length, z > 0. coat_normal: the clear coat's, unit length, on its side.
  /// base_albedo: luminance of what is below, for the choice of lobes.
  CoverLayers(const Reflectance& reflectance, const Vec3& outgoing, const Vec3& coat_normal,
              float base_albedo, const ScatteringTables& tables);

  /// With which all that is below is multiplied.
  float base_scale() const { return base_scale_; }

  float clearcoat_probability() const { return clearcoat_probability_; }
  float sheen_probability() const { return sheen_probability_; }
  float base_probability() const { return 1.0F - clearcoat_probability_ - sheen_probability_; }

  /// The only direction that a smooth clear coat reflects from; empty if it is rough.
  struct Mirror {
    Vec3 incoming;
    float reflectance;
  };
  std::optional<Mirror> clearcoat_mirror() const;
  /// A direction that a rough clear coat reflects from; empty if it lies below the coat.
  std::optional<Vec3> sample_clearcoat(const Vec2& u) const;

  /// The base's value under the layers, and theirs. incoming: unit length, reflected.
  BsdfValue over(const BsdfValue& base, const Vec3& incoming) const;

 private:
  Frame coat_frame_;
  Vec3 coat_outgoing_;  ///< in that frame
  MicrofacetLobe clearcoat_;
  float clearcoat_strength_;
  CharlieSheen sheen_;
  Rgb sheen_color_{0.0F};  ///< times what is left below the clearcoat
  float base_scale_ = 1.0F;
  float clearcoat_probability_ = 0.0F;
  float sheen_probability_ = 0.0F;
};

}  // namespace foveola
