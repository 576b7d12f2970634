// Decodes the compressed geometry of a glTF file's extensions.
#pragma once

#include "renderer/scene/gltf/model.h"

namespace foveola {

/// EXT_meshopt_compression: gives each compressed buffer view a buffer of its own with the decoded
/// bytes. Throws GltfFault if one cannot be decoded or if all together exceed
/// require_modest_memory.
void decompress_meshopt(GltfModel& model);

/// KHR_draco_mesh_compression: gives the accessors of each compressed primitive buffer views in
/// buffers of their own with the decoded values. Throws GltfFault if one cannot be decoded, has
/// more vertices or triangles than its accessors state, or if all together exceed
/// require_modest_memory.
void decompress_draco(GltfModel& model);

}  // namespace foveola
