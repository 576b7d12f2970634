// The JSON part of a glTF file, checked before tinygltf, which takes much on trust, may read it.
// The text is parsed here and by tinygltf, which takes nothing else: each of the two takes about
// 1 ms for the 80 to 180 kB of the built-in scenes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foveola {

/// How a JPEG image in the file itself begins where its exporter does not know that the type's name
/// is image/jpeg.
inline constexpr std::string_view jpg_data_uri = "data:image/jpg;base64,";

/// What tinygltf takes for a file beside the scene file.
struct GltfReference {
  std::string place;      ///< the JSON path of the uri
  std::string uri;        ///< as written, percent-encoded; of an image it may be a jpg_data_uri
  bool is_image = false;  ///< not a buffer
};

/// Checks that `json` is a glTF 2.0 document that Foveola can show: every property that the loader
/// reads has the type that the specification (Khronos, glTF 2.0.1) gives it, every index points at
/// something, every buffer view lies inside its buffer's stated length, and no required extension
/// is unknown. Returns the files it refers to: first those of the buffers, then the images', each
/// in the document's order. Throws GltfFault.
std::vector<GltfReference> check_gltf_document(std::string_view json);

/// Whether Foveola renders what this glTF extension adds.
bool is_supported_extension(std::string_view name);

}  // namespace foveola
