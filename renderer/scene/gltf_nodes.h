// Flattens glTF's hierarchy of nodes: where each mesh and camera stands in the world.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace tinygltf {
class Model;
}

namespace foveola {

/// One appearance of a mesh.
struct MeshInstance {
  DMat4 world_from_local{1.0};
  std::string name;  ///< the node's, else the mesh's
};

struct PlacedNodes {
  std::vector<std::vector<MeshInstance>> instances;  ///< by index of the glTF mesh
  std::vector<CameraView> cameras;                   ///< the perspective ones
};

/// Visits the nodes of the default scene (else the first; else, where a file has no scenes, all
/// root nodes). Throws GltfFault, naming the place, if the nodes are not a strict tree or a
/// transform is not finite.
PlacedNodes place_nodes(const tinygltf::Model& model, Warnings& warnings);

}  // namespace foveola
