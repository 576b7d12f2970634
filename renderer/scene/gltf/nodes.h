// Flattens glTF's hierarchy of nodes: where each mesh, camera and light stands in the world.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/gltf/model.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// A node that shows something, in double precision.
struct Placement {
  int node = 0;
  DMat4 world_from_local{1.0};
};

/// One appearance of what `index` counts.
struct PlacedItem {
  std::size_t index = 0;
  Placement placement;
};

struct PlacedNodes {
  std::vector<std::vector<Placement>> meshes;  ///< by index of the glTF mesh
  std::vector<PlacedItem> cameras;             ///< in the order of the nodes
  std::vector<PlacedItem> lights;              ///< in the order of the nodes
  std::vector<DMat4> world_from_node;          ///< of each node; the identity for those not visited
};

/// Visits the nodes of the default scene (else the first; else, where a file has no scenes, all
/// root nodes). Of a node that KHR_node_visibility hides, and of those below it, no mesh and no
/// light is placed; EXT_mesh_gpu_instancing places a mesh several times. Throws GltfFault, naming
/// the place, if the nodes are not a strict tree or a transform is not finite.
PlacedNodes place_nodes(const GltfModel& model, Warnings& warnings);

/// The perspective cameras, their positions seen from `origin`. A roll about the line of sight,
/// which a head does not have, becomes a warning.
std::vector<CameraView> read_cameras(const GltfModel& model, const std::vector<PlacedItem>& cameras,
                                     const DVec3& origin, Warnings& warnings);

}  // namespace foveola
