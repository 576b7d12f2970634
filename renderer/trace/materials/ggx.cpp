#include "renderer/trace/materials/ggx.h"

namespace foveola {

Vec3 fine_half_vector(const Vec3& a, const Vec3& b) {
  return Vec3(glm::normalize(glm::normalize(DVec3(a)) + glm::normalize(DVec3(b))));
}

}  // namespace foveola
