#include "renderer/scene/scene.h"

#include <algorithm>

#include <glm/vector_relational.hpp>

namespace foveola {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Bounds nowhere{.lower = Vec3(infinity), .upper = Vec3(-infinity)};

void include(Bounds& bounds, const Vec3& point) {
  bounds.lower = glm::min(bounds.lower, point);
  bounds.upper = glm::max(bounds.upper, point);
}

bool holds(const Bounds& outer, const Bounds& inner) {
  return glm::all(glm::greaterThanEqual(inner.lower, outer.lower)) &&
         glm::all(glm::lessThanEqual(inner.upper, outer.upper));
}

/// The box of a mesh's vertices at the instance's place. Rounding is monotonic, so that no
/// transformed vertex lies outside.
Bounds box_of(const Instance& instance, const Bounds& mesh) {
  Bounds box = nowhere;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec4 place((corner & 1U) != 0 ? mesh.lower.x : mesh.upper.x,
                     (corner & 2U) != 0 ? mesh.lower.y : mesh.upper.y,
                     (corner & 4U) != 0 ? mesh.lower.z : mesh.upper.z, 1.0F);
    include(box, Vec3(instance.world_from_local * place));
  }
  return box;
}

/// The numbers of the boxes with the extreme sides along each axis.
std::vector<std::size_t> farthest(const std::vector<Bounds>& boxes) {
  std::vector<std::size_t> numbers;
  for (int axis = 0; axis < 3 && !boxes.empty(); ++axis) {
    const auto by_lower = [axis](const Bounds& box) { return box.lower[axis]; };
    const auto by_upper = [axis](const Bounds& box) { return box.upper[axis]; };
    numbers.push_back(std::ranges::min_element(boxes, {}, by_lower) - boxes.begin());
    numbers.push_back(std::ranges::max_element(boxes, {}, by_upper) - boxes.begin());
  }
  return numbers;
}

}  // namespace

std::size_t array_bytes(const Mesh& mesh) {
  const auto bytes_of = [](const auto& list) { return list.size() * sizeof list[0]; };
  std::size_t bytes = bytes_of(mesh.positions) + bytes_of(mesh.normals) + bytes_of(mesh.tangents) +
                      bytes_of(mesh.colors) + bytes_of(mesh.triangles);
  for (const std::vector<Vec2>& uvs : mesh.uv_sets) {
    bytes += bytes_of(uvs);
  }
  return bytes;
}

std::vector<Bounds> boxes_of_instances(const Scene& scene) {
  std::vector<Bounds> prototypes(scene.prototypes.size(), nowhere);
  for (std::size_t i = 0; i < prototypes.size(); ++i) {
    for (const Vec3& position : scene.prototypes[i].positions) {
      include(prototypes[i], position);
    }
  }
  std::vector<Bounds> boxes;
  boxes.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances) {
    const bool is_empty = scene.prototypes[instance.prototype].positions.empty();
    boxes.push_back(is_empty ? nowhere : box_of(instance, prototypes[instance.prototype]));
  }
  return boxes;
}

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
  Bounds bounds = nowhere;
  for (const Vec3& position : mesh_of(object).positions) {
    include(bounds, in_world(object, position));
  }
  return bounds;
}

Bounds Scene::bounds() const {
  Bounds all = nowhere;
  const auto add = [&](std::size_t object) {
    const Bounds more = bounds_of(static_cast<std::uint32_t>(object));
    all.lower = glm::min(all.lower, more.lower);
    all.upper = glm::max(all.upper, more.upper);
  };
  for (std::size_t object = 0; object < meshes.size(); ++object) {
    add(object);
  }
  const std::vector<Bounds> boxes = boxes_of_instances(*this);
  // Instances with extreme boxes come first: then few others may have a vertex beyond them.
  for (const std::size_t instance : farthest(boxes)) {
    add(meshes.size() + instance);
  }
  for (std::size_t instance = 0; instance < boxes.size(); ++instance) {
    if (!holds(all, boxes[instance])) {
      add(meshes.size() + instance);
    }
  }
  return all.lower.x <= all.upper.x ? all : Bounds{};
}

}  // namespace foveola
