#include "renderer/view/equirect.h"

namespace foveola {

double equirect_area_per_sr(const Vec3& direction) {
  const DVec3 d(direction);
  const double cos_elevation = std::hypot(d.x, d.z) / glm::length(d);
  return 1.0 / (2.0 * std::numbers::pi * std::numbers::pi * cos_elevation);
}

}  // namespace foveola
