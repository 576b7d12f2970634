// Moves the vertices of a glTF mesh as its morph targets and its skin do in one pose.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/gltf/accessor.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// What a node does to the vertices of its mesh.
struct Deformation {
  std::vector<double> weights;  ///< of the morph targets; missing ones are 0
  /// For each joint of the skin, where it takes vertices from the mesh's space: into the world.
  /// Empty without a skin.
  std::vector<DMat4> joints;
};

/// Whether a skin moves the mesh of `node` into the world, so that the node's own place counts for
/// nothing: all primitives of the mesh name joints.
bool is_skinned(const GltfModel& model, const GltfNode& node);

/// Lets every node whose mesh has a skin or weights of the node's own have that mesh for itself
/// alone. Throws GltfFault if that takes more than 2^20 copies of primitives.
void separate_deformed_meshes(GltfModel& model);

/// The deformation of the mesh that `node` shows. world_from_node: of all nodes, by their index.
/// Throws GltfFault if the skin has fewer inverse bind matrices than joints.
Deformation deformation_of(const GltfModel& model, const GltfNode& node,
                           const std::vector<DMat4>& world_from_node);

/// Moves positions, normals and tangents of `mesh`, which holds the vertices of `primitive` that
/// `reader` reads. Throws GltfFault, with places below `place`, as read_vec3s does, and for a joint
/// that the skin does not have.
void deform(Mesh& mesh, const VertexReader& reader, const GltfPrimitive& primitive,
            const Deformation& deformation, const std::string& place, Warnings& warnings);

}  // namespace foveola
