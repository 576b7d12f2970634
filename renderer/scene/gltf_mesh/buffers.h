// Loads the bytes of a glTF file's buffers.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "renderer/scene/gltf/model.h"
#include "renderer/scene/scene_hash.h"

namespace foveola {

/// Fills each buffer of `model` with its stated number of bytes: from data: uris, from files in
/// `folder`, or, for the first buffer, from `binary`, the file's own chunk. Buffers that are unused
/// and have no uri stay empty, and so does EXT_meshopt_compression's fallback. Returns SHA-256s of
/// the files read. Throws GltfFault if a buffer is incomplete.
FileHashes read_gltf_buffers(GltfModel& model, std::string_view binary,
                             const std::filesystem::path& folder);

/// require_modest_memory, with a GltfFault at `place`.
void require_gltf_memory_limit(std::size_t decoded_bytes, std::size_t encoded_bytes,
                               const std::string& place);

}  // namespace foveola
