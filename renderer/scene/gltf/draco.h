// Decodes the primitives that KHR_draco_mesh_compression compresses in a glTF file.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace foveola {

/// Gives the accessors of each compressed primitive of a checked document buffer views in buffers
/// of their own with the decoded values, added to the document and to `buffers`. Throws GltfFault
/// if one cannot be decoded, has more vertices or triangles than its accessors state, or if all
/// together take more memory than require_modest_memory grants.
void decompress_draco(nlohmann::json& document, std::vector<std::vector<unsigned char>>& buffers);

}  // namespace foveola
