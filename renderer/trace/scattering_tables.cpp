#include "renderer/trace/scattering_tables.h"

#include <algorithm>
#include <cassert>

namespace foveola {

ScatteringTables::ScatteringTables(std::span<const Material> materials, const Workers& workers)
    : ggx_(workers) {
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
