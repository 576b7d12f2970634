// Decodes what EXT_meshopt_compression compresses in a glTF file.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace foveola {

/// Gives each compressed buffer view of a checked document a buffer of its own with the decoded
/// bytes, added to the document and to `buffers`, and takes the extension off it. Throws GltfFault
/// if one cannot be decoded or all together take more memory than require_modest_memory grants.
void decompress_meshopt(nlohmann::json& document, std::vector<std::vector<unsigned char>>& buffers);

}  // namespace foveola
