// Summarises a scene's content for its users.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace foveola {

struct SceneFacts {
  std::size_t objects = 0;
  std::size_t instances = 0;
  std::size_t triangles = 0;         ///< as seen: each instance counted
  std::size_t stored_triangles = 0;  ///< stored in memory
  std::size_t emissive_triangles = 0;
  std::size_t lights = 0;  ///< points, spots and directional ones
  std::size_t materials = 0;
  std::size_t textures = 0;
  std::size_t geometry_bytes = 0;  ///< the loaded arrays, without the tracer's hierarchy
  std::size_t texture_bytes = 0;   ///< with their mip levels; shared texels once
  std::size_t environment_bytes = 0;
  Bounds bounds;
  /// Names of the renderer's features that the scene uses, and of those that it does not.
  std::vector<std::string> features;
  std::vector<std::string> absent_features;
};

SceneFacts facts_of(const Scene& scene);

/// Whether anything emits: an environment, a surface, or a light where there are surfaces. Does not
/// look into textures.
bool has_light(const Scene& scene);

}  // namespace foveola
