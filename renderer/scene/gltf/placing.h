// Places glTF meshes at their nodes, as copies in the world or as instances, and chooses the
// world's origin.
#pragma once

#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/gltf/nodes.h"
#include "renderer/scene/gltf_mesh/geometry.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// A glTF mesh in its own space: one Mesh for each of its renderable primitives.
using LocalMesh = std::vector<Mesh>;

/// (0, 0, 0), unless the nodes' content lies further from it than 8 times its half diagonal. Then a
/// point near its centre, rounded to multiples of a power of two about as large as the half
/// diagonal, which keeps short coordinates short. placements: for each mesh.
DVec3 choose_origin(const std::vector<LocalMesh>& meshes,
                    const std::vector<std::vector<Placement>>& placements);

enum class Placing {
  copies_where_few,
  instances,  ///< so that moved meshes are recognised in the next version of the scene
};

/// Adds `meshes` to `scene`, around scene.origin. With copies_where_few, a mesh is copied into the
/// world at each of its nodes, which traces fastest. If that adds more than 65 536 triangles, or
/// all copies more than 2^22, it becomes prototypes and instances; nodes whose transform has no
/// inverse in single precision still get copies. Throws GltfFault if `budget` is exceeded.
void add_meshes(Scene& scene, std::vector<LocalMesh> meshes, const PlacedNodes& nodes,
                const GltfModel& model, Placing placing, MemoryBudget& budget, Warnings& warnings);

}  // namespace foveola
