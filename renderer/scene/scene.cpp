#include "renderer/scene/scene.h"

#include <limits>

namespace foveola {

std::size_t Scene::triangle_count() const {
  std::size_t count = 0;
  for (const Mesh& mesh : meshes) {
    count += mesh.triangles.size();
  }
  return count;
}

Bounds Scene::bounds() const {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Bounds bounds{.lower = Vec3(infinity), .upper = Vec3(-infinity)};
  for (const Mesh& mesh : meshes) {
    for (const Vec3& position : mesh.positions) {
      bounds.lower = glm::min(bounds.lower, position);
      bounds.upper = glm::max(bounds.upper, position);
    }
  }
  return bounds.lower.x <= bounds.upper.x ? bounds : Bounds{};
}

}  // namespace foveola
