// Puts glTF meshes where their nodes stand: copied into the world, or kept once and shown by
// instances; and chooses the world's origin.
#pragma once

#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/gltf/geometry.h"
#include "renderer/scene/gltf/nodes.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// A glTF mesh: one Mesh for each of its primitives that can be shown, in its own space.
using LocalMesh = std::vector<Mesh>;

/// (0, 0, 0), unless what the nodes show lies further from there than 8 times its half diagonal:
/// then about its centre, rounded to a multiple of a power of two about as large as the half
/// diagonal, so that short coordinates stay short. placements: for each mesh.
DVec3 choose_origin(const std::vector<LocalMesh>& meshes,
                    const std::vector<std::vector<Placement>>& placements);

enum class Placing {
  copies_where_few,
  instances,  ///< so that what stands elsewhere in the next version of the scene is known again
};

/// Adds `meshes` to `scene`, around scene.origin. With copies_where_few, a mesh becomes a copy in
/// the world at each of its nodes, which is the fastest to trace, unless that would add more than
/// 65 536 triangles, or all copies more than 2^22; then it becomes prototypes and instances, but
/// for nodes whose transform has no inverse in single precision. Throws GltfFault if that takes
/// more than `budget` has.
void add_meshes(Scene& scene, std::vector<LocalMesh> meshes, const PlacedNodes& nodes,
                const GltfModel& model, Placing placing, MemoryBudget& budget, Warnings& warnings);

}  // namespace foveola
