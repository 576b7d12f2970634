#include "renderer/trace/scattering_tables.h"

#include <algorithm>
#include <cassert>

namespace foveola {
namespace {

/// The roughnesses of a surface: a texture makes it smoother in places.
RoughnessInterval roughnesses(float roughness, const TextureUse& texture) {
  return {.least = texture.exists() ? 0.0F : roughness, .most = roughness};
}

std::vector<RoughnessInterval> ggx_roughnesses(std::span<const Material> materials) {
  std::vector<RoughnessInterval> all;
  for (const Material& material : materials) {
    all.push_back(roughnesses(material.roughness, material.metallic_roughness_texture));
    all.push_back(roughnesses(material.clearcoat_roughness, material.clearcoat_roughness_texture));
  }
  return all;
}

}  // namespace

ScatteringTables::ScatteringTables(std::span<const Material> materials, const Workers& workers)
    : ggx_(ggx_roughnesses(materials), workers) {
  for (const Material& material : materials) {
    if (!sheen_ && max_component(material.sheen_color) > 0.0F) {
      sheen_.emplace(workers);
    }
    const bool is_known = std::any_of(glass_.begin(), glass_.end(), [&](const GlassAlbedo& glass) {
      return glass.ior() == material.ior;
    });
    if (material.is_solid && material.transmission > 0.0F && !is_known &&
        is_rough_glass(material.ior, material.roughness)) {
      glass_.emplace_back(material.ior, workers);
    }
  }
}

const GlassAlbedo& ScatteringTables::glass(float ior) const {
  const auto found = std::find_if(glass_.begin(), glass_.end(),
                                  [=](const GlassAlbedo& glass) { return glass.ior() == ior; });
  assert(found != glass_.end());
  return *found;
}

}  // namespace foveola
