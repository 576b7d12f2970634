#include "renderer/scene/scene.h"

#include <algorithm>
#include <limits>

namespace foveola {

const Mesh& Scene::mesh_of(std::uint32_t object) const {
  const Instance* instance = instance_of(object);
  return instance == nullptr ? meshes[object] : prototypes[instance->prototype];
}

const Instance* Scene::instance_of(std::uint32_t object) const {
  return object < meshes.size() ? nullptr : &instances[object - meshes.size()];
}

const std::string& Scene::object_name(std::uint32_t object) const {
  const Instance* instance = instance_of(object);
  return instance == nullptr ? meshes[object].name : instance->name;
}

std::size_t Scene::triangle_count() const {
  std::size_t count = 0;
  for (std::uint32_t object = 0; object < object_count(); ++object) {
    count += mesh_of(object).triangles.size();
  }
  return count;
}

Bounds Scene::bounds() const {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Bounds bounds{.lower = Vec3(infinity), .upper = Vec3(-infinity)};
  const auto include = [&](const Vec3& position) {
    bounds.lower = glm::min(bounds.lower, position);
    bounds.upper = glm::max(bounds.upper, position);
  };
  for (const Mesh& mesh : meshes) {
    std::for_each(mesh.positions.begin(), mesh.positions.end(), include);
  }
  for (const Instance& instance : instances) {
    for (const Vec3& position : prototypes[instance.prototype].positions) {
      include(Vec3(instance.world_from_local * Vec4(position, 1.0F)));
    }
  }
  return bounds.lower.x <= bounds.upper.x ? bounds : Bounds{};
}

}  // namespace foveola
