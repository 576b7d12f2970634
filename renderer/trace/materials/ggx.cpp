#include "renderer/trace/materials/ggx.h"

namespace foveola {

Vec3 half_vector_in_double(const Vec3& a, const Vec3& b) {
  return Vec3(glm::normalize(glm::normalize(DVec3(a)) + glm::normalize(DVec3(b))));
}

}  // namespace foveola
