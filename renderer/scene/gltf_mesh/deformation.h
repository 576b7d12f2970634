// Deforms the vertices of a glTF mesh by its morph targets and its skin in one pose.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/gltf_mesh/accessor.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// The deformation of a mesh by its node.
struct Deformation {
  std::vector<double> weights;  ///< of the morph targets; missing ones are 0
  /// For each joint of the skin, the transform of vertices from the mesh's space to the world.
  /// Empty without a skin.
  std::vector<DMat4> joints;
};

/// Whether a skin moves the mesh of `node` into the world, in place of the node's own transform:
/// all primitives of the mesh name joints.
bool is_skinned(const GltfModel& model, const GltfNode& node);

/// Copies meshes so that every node whose mesh has a skin or the node's own weights has that mesh
/// for itself alone. Throws GltfFault if that takes more than 2^20 copies of primitives.
void separate_deformed_meshes(GltfModel& model);

/// The deformation of the mesh of `node`. world_from_node: of all nodes, by index. Throws GltfFault
/// if the skin has fewer inverse bind matrices than joints.
Deformation deformation_of(const GltfModel& model, const GltfNode& node,
                           const std::vector<DMat4>& world_from_node);

/// Deforms positions, normals and tangents of `mesh`, whose vertices `reader` reads from
/// `primitive`. Throws GltfFault, with places below `place`, as read_vec3s does, and for a joint
/// that the skin lacks.
void deform(Mesh& mesh, const VertexReader& reader, const GltfPrimitive& primitive,
            const Deformation& deformation, const std::string& place, Warnings& warnings);

}  // namespace foveola
