#include "renderer/scene/prepare/nested_volumes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <glm/vector_relational.hpp>

#include "renderer/scene/prepare/sanitised.h"

namespace foveola {
namespace {

// Limits to fractions of a second.
constexpr std::size_t max_vertices = 30'000'000;
constexpr std::size_t max_comparisons = 10'000'000;

struct Volume {
  std::uint32_t object = 0;
  Bounds bounds;
};

/// The refracting volumes, in order of their lower x.
std::vector<Volume> volumes_of(const Scene& scene) {
  std::vector<Volume> volumes;
  std::size_t vertices = 0;
  for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
    const Mesh& mesh = scene.mesh_of(object);
    const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    if (!material.refracts()) {
      continue;
    }
    vertices += mesh.positions.size();
    if (vertices > max_vertices) {
      break;
    }
    volumes.push_back({.object = object, .bounds = scene.bounds_of(object)});
  }
  std::ranges::sort(volumes, [](const Volume& a, const Volume& b) {
    return a.bounds.lower.x < b.bounds.lower.x;
  });
  return volumes;
}

bool lies_within(const Bounds& inner, const Bounds& outer) {
  return glm::all(glm::greaterThanEqual(inner.lower, outer.lower)) &&
         glm::all(glm::lessThanEqual(inner.upper, outer.upper));
}

std::string warning(const Scene& scene, const Volume& inner, const Volume& outer) {
  return fmt::format(
      "{} may lie within {}, and both refract light: at its surface light is refracted as if it "
      "stood in air",
      sanitised(scene.object_name(inner.object)), sanitised(scene.object_name(outer.object)));
}

}  // namespace

std::optional<std::string> warning_of_nested_volumes(const Scene& scene) {
  const std::vector<Volume> volumes = volumes_of(scene);
  std::size_t comparisons = 0;
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const Bounds& bounds = volumes[i].bounds;
    for (std::size_t k = i + 1; k < volumes.size() && volumes[k].bounds.lower.x <= bounds.upper.x;
         ++k) {
      if (++comparisons > max_comparisons) {
        return std::nullopt;
      }
      if (lies_within(volumes[k].bounds, bounds)) {
        return warning(scene, volumes[k], volumes[i]);
      }
      if (lies_within(bounds, volumes[k].bounds)) {
        return warning(scene, volumes[i], volumes[k]);
      }
    }
  }
  return std::nullopt;
}

}  // namespace foveola
