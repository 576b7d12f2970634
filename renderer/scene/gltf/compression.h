// Decodes the geometry that extensions compress in a glTF file.
#pragma once

#include "renderer/scene/gltf/model.h"

namespace foveola {

/// EXT_meshopt_compression: gives each compressed buffer view a buffer of its own with the decoded
/// bytes. Throws GltfFault if one cannot be decoded or all together take more memory than
/// require_modest_memory grants.
void decompress_meshopt(GltfModel& model);

/// KHR_draco_mesh_compression: gives the accessors of each compressed primitive buffer views in
/// buffers of their own with the decoded values. Throws GltfFault if one cannot be decoded, has
/// more vertices or triangles than its accessors state, or if all together take more memory than
/// require_modest_memory grants.
void decompress_draco(GltfModel& model);

}  // namespace foveola
