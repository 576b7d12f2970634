// The two parts of a glTF file: its JSON, and the buffer that a binary one holds beside it.
#pragma once

#include <string_view>

namespace foveola {

struct GltfParts {
  std::string_view json;
  std::string_view binary;  ///< what buffers[0] holds if it has no uri; empty if there is none
};

/// The parts of a .glb file (it begins with "glTF"; specification, section 4) or of a .gltf file,
/// which is all JSON. Throws GltfFault for a binary that is truncated, of another version, or whose
/// chunks do not fit into it.
GltfParts gltf_parts(std::string_view content);

/// Whether the file is a .glb, by its first bytes.
bool is_gltf_binary(std::string_view content);

}  // namespace foveola
