// The bytes of a glTF file's buffers, wherever they lie.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "renderer/scene/gltf/model.h"
#include "renderer/scene/scene_hash.h"

namespace foveola {

/// Gives each buffer of `model` as many bytes as it states, or none if nothing uses it and it has
/// no uri, or is EXT_meshopt_compression's fallback: those in data: uris, in files in `folder`, or,
/// the first buffer's, in `binary`, the file's own chunk. Returns SHA-256s of the files that were
/// read. Throws GltfFault if a buffer cannot be had whole.
FileHashes read_gltf_buffers(GltfModel& model, std::string_view binary,
                             const std::filesystem::path& folder);

/// require_modest_memory, whose fault is a GltfFault at `place`.
void require_modest_gltf_memory(std::size_t decoded_bytes, std::size_t encoded_bytes,
                                const std::string& place);

}  // namespace foveola
