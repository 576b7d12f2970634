// The bytes of a glTF file's buffers, wherever they lie.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "renderer/scene/scene_hash.h"

namespace foveola {

struct GltfBuffers {
  /// For each buffer, as many bytes as it states; none if nothing uses it and it has no uri,
  /// or is EXT_meshopt_compression's fallback.
  std::vector<std::vector<unsigned char>> contents;
  FileHashes hashes;  ///< SHA-256s of the files that were read
};

/// The buffers of a checked document: in data: uris, in files in `folder`, or, the first, in
/// `binary`, the file's own chunk. Throws GltfFault if one cannot be had whole.
GltfBuffers read_gltf_buffers(const nlohmann::json& document, std::string_view binary,
                              const std::filesystem::path& folder);

}  // namespace foveola
