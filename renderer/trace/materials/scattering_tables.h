// The albedo tables for the BSDFs of one scene.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/materials/ggx.h"
#include "renderer/trace/materials/ggx_albedo.h"
#include "renderer/trace/materials/sheen.h"

namespace foveola {

/// The albedo of rough glass of one index of refraction, from outside and from inside. Within 5e-4
/// of the integral.
class GlassAlbedo {
 public:
  /// ior: > 1, of the inside over the outside.
  GlassAlbedo(float ior, const Workers& workers);

  float ior() const { return ior_; }

  /// Reflected plus transmitted share of the power. roughness: in [min_roughness, 1]. cosine:
  /// between the normal and the direction, in [0, 1].
  float at(float roughness, float cosine, bool from_inside) const;

 private:
  float ior_;
  std::vector<float> nodes_;  ///< side, roughness, position of the cosine
};

/// Minimum index of refraction of rough glass: below it the roughness is invisible.
constexpr float min_rough_ior = 1.001F;

/// Whether a glass material counts as rough.
inline bool is_rough_glass(float ior, float roughness) {
  return ior >= min_rough_ior && roughness >= min_roughness;
}

class ScatteringTables {
 public:
  ScatteringTables(std::span<const Material> materials, const Workers& workers);

  const GgxAlbedo& ggx() const { return ggx_; }
  /// Requires a material with sheen.
  const SheenAlbedo& sheen() const { return *sheen_; }
  /// Requires a material of rough solid glass with this index of refraction.
  const GlassAlbedo& glass(float ior) const;

 private:
  GgxAlbedo ggx_;
  std::optional<SheenAlbedo> sheen_;
  std::vector<GlassAlbedo> glass_;  ///< one per distinct index of refraction
};

}  // namespace foveola
