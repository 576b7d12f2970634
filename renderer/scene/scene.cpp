#include "renderer/scene/scene.h"

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

Vec3 Scene::in_world(std::uint32_t object, const Vec3& position) const {
  const Instance* instance = instance_of(object);
  return instance == nullptr ? position : Vec3(instance->world_from_local * Vec4(position, 1.0F));
}

std::size_t Scene::triangle_count() const {
  std::size_t count = 0;
  for (std::uint32_t object = 0; object < object_count(); ++object) {
    count += mesh_of(object).triangles.size();
  }
  return count;
}

Bounds Scene::bounds_of(std::uint32_t object) const {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Bounds bounds{.lower = Vec3(infinity), .upper = Vec3(-infinity)};
  for (const Vec3& position : mesh_of(object).positions) {
    const Vec3 placed = in_world(object, position);
    bounds.lower = glm::min(bounds.lower, placed);
    bounds.upper = glm::max(bounds.upper, placed);
  }
  return bounds;
}

Bounds Scene::bounds() const {
  if (object_count() == 0) {
    return {};
  }
  Bounds bounds = bounds_of(0);
  for (std::uint32_t object = 1; object < object_count(); ++object) {
    const Bounds more = bounds_of(object);
    bounds.lower = glm::min(bounds.lower, more.lower);
    bounds.upper = glm::max(bounds.upper, more.upper);
  }
  return bounds.lower.x <= bounds.upper.x ? bounds : Bounds{};
}

}  // namespace foveola
