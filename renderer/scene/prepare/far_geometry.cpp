#include "renderer/scene/prepare/far_geometry.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace foveola {
namespace {

std::string beyond_limit(const char* what) {
  return fmt::format("{} beyond {:.2g} m, where no ray can be traced, are left out", what,
                     max_coordinate_m);
}

void drop_far_triangles(Mesh& mesh, Warnings& warnings) {
  if (std::ranges::all_of(mesh.positions, is_traceable)) {
    return;
  }
  const std::size_t dropped =
      std::erase_if(mesh.triangles, [&](const std::array<std::uint32_t, 3>& corners) {
        return std::ranges::any_of(
            corners, [&](std::uint32_t corner) { return !is_traceable(mesh.positions[corner]); });
      });
  // Unused vertices must not count for the scene's bounds.
  std::replace_if(
      mesh.positions.begin(), mesh.positions.end(),
      [](const Vec3& position) { return !is_traceable(position); },
      mesh.triangles.empty() ? Vec3(0.0F) : mesh.positions[mesh.triangles.front()[0]]);
  warnings.add(beyond_limit("triangles"), mesh.name, dropped);
}

}  // namespace

bool is_traceable(const Vec3& position) {
  return glm::all(glm::lessThanEqual(glm::abs(position), Vec3(max_coordinate_m)));
}

void drop_far_parts(Scene& scene, Warnings& warnings) {
  for (Mesh& mesh : scene.meshes) {
    drop_far_triangles(mesh, warnings);
  }
  std::vector<Instance> kept;
  const std::vector<Bounds> boxes = boxes_of_instances(scene);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const bool is_empty = boxes[i].lower.x > boxes[i].upper.x;
    if (is_empty || (is_traceable(boxes[i].lower) && is_traceable(boxes[i].upper))) {
      kept.push_back(std::move(scene.instances[i]));
    } else {
      warnings.add(beyond_limit("objects"), scene.instances[i].name);
    }
  }
  scene.instances = std::move(kept);
  std::erase_if(scene.lights, [&](const PunctualLight& light) {
    const bool is_far =
        light.kind != PunctualLight::Kind::directional && !is_traceable(light.position);
    if (is_far) {
      warnings.add(beyond_limit("lights"), light.name);
    }
    return is_far;
  });
}

}  // namespace foveola
