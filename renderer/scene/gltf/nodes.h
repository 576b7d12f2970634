// Flattens glTF's node hierarchy: world transforms of meshes, cameras and lights.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/gltf/model.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// A node with content, in double precision.
struct Placement {
  int node = 0;
  DMat4 world_from_local{1.0};
};

/// One appearance of the item `index`.
struct PlacedItem {
  std::size_t index = 0;
  Placement placement;
};

struct PlacedNodes {
  std::vector<std::vector<Placement>> meshes;  ///< by index of the glTF mesh
  std::vector<PlacedItem> cameras;             ///< in the order of the nodes
  std::vector<PlacedItem> lights;              ///< in the order of the nodes
  std::vector<DMat4> world_from_node;          ///< per node; the identity for nodes not visited
};

/// Visits the nodes of the default scene, else of the first, else, in a file without scenes, all
/// root nodes. Meshes and lights at and below a node that KHR_node_visibility hides are left out.
/// EXT_mesh_gpu_instancing places a mesh several times. Throws GltfFault at the place if the nodes
/// are not a strict tree or a transform is not finite.
PlacedNodes place_nodes(const GltfModel& model, Warnings& warnings);

/// The perspective cameras, positioned relative to `origin`. A roll about the line of sight, which
/// a head does not have, becomes a warning.
std::vector<CameraView> read_cameras(const GltfModel& model, const std::vector<PlacedItem>& cameras,
                                     const DVec3& origin, Warnings& warnings);

}  // namespace foveola
