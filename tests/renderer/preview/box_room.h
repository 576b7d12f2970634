// A scene small enough for the tests of the frame loop: a lit box around the origin.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/scene/scene.h"

namespace foveola {

/// A cube of half side 1 around the origin. Its walls reflect half of the light and glow with
/// `radiance` plus 0.1 for each wall before them (-X, +X, -Y, +Y, -Z, +Z), so that light bounces
/// and the image has both noise and edges.
inline Scene box_room(float radiance) {
  constexpr std::array<std::array<std::uint32_t, 4>, 6> walls = {
      {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}}};
  Scene scene;
  for (const auto& wall : walls) {
    Material material;
    material.base_color = Rgb(0.5F);
    material.emission = Rgb(radiance + 0.1F * static_cast<float>(scene.meshes.size()));
    material.double_sided = true;
    Mesh mesh;
    mesh.material = static_cast<int>(scene.materials.size());
    for (const std::uint32_t corner : wall) {
      mesh.positions.emplace_back((corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1,
                                  (corner & 4U) != 0 ? 1 : -1);
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.materials.push_back(material);
    scene.meshes.push_back(mesh);
  }
  return scene;
}

}  // namespace foveola
