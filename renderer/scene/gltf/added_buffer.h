// What the decoders of compressed geometry share: they add buffers to a glTF document.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace foveola {

/// Adds a buffer of these bytes to the document and to its buffers, and returns its index.
std::size_t add_gltf_buffer(nlohmann::json& document,
                            std::vector<std::vector<unsigned char>>& buffers,
                            std::vector<unsigned char> bytes);

/// require_modest_memory, whose fault is a GltfFault at `place`.
void require_modest_gltf_memory(std::size_t decoded_bytes, std::size_t encoded_bytes,
                                const std::string& place);

}  // namespace foveola
