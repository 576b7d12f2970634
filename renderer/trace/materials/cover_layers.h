// Layers over a surface: clearcoat, and sheen below it.
#pragma once

#include <optional>

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/ggx.h"
#include "renderer/trace/materials/scattering_tables.h"
#include "renderer/trace/materials/sheen.h"

namespace foveola {

/// Each layer transmits the light that it does not reflect, by its albedo for the outgoing
/// direction.
class CoverLayers {
 public:
  /// outgoing: unit length, z > 0. coat_normal: of the clear coat, unit length, on its side.
  /// base_albedo: luminance of the base, for the choice of lobes.
  CoverLayers(const Reflectance& reflectance, const Vec3& outgoing, const Vec3& coat_normal,
              float base_albedo, const ScatteringTables& tables);

  /// Factor on everything below the layers.
  float base_scale() const { return base_scale_; }

  float clearcoat_probability() const { return clearcoat_probability_; }
  float sheen_probability() const { return sheen_probability_; }
  float base_probability() const { return 1.0F - clearcoat_probability_ - sheen_probability_; }

  /// The only direction that a smooth clear coat reflects; nullopt if it is rough.
  struct Mirror {
    Vec3 incoming;
    float reflectance;
  };
  std::optional<Mirror> clearcoat_mirror() const;
  /// A direction reflected by a rough clear coat; nullopt if it lies below the coat.
  std::optional<Vec3> sample_clearcoat(const Vec2& u) const;

  /// The sum of the base's value below the layers and their own. incoming: unit length, reflected.
  BsdfValue over(const BsdfValue& base, const Vec3& incoming) const;

 private:
  Frame coat_frame_;
  Vec3 coat_outgoing_;  ///< in that frame
  MicrofacetLobe clearcoat_;
  float clearcoat_strength_;
  CharlieSheen sheen_;
  Rgb sheen_color_{0.0F};  ///< times the share left below the clearcoat
  float base_scale_ = 1.0F;
  float clearcoat_probability_ = 0.0F;
  float sheen_probability_ = 0.0F;
};

}  // namespace foveola
