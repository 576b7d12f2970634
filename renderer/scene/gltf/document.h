// The JSON part of a glTF file, checked before anything is made of it.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace foveola {

/// The glTF 2.0 document in `json`, if Foveola can show it: every property that the loader reads
/// has the type that the specification (Khronos, glTF 2.0.1) gives it, every index points at
/// something, every buffer view lies inside its buffer's stated length, and no required extension
/// is unknown. Whole numbers may be written as 1.0. Throws GltfFault.
nlohmann::json checked_gltf_document(std::string_view json);

/// Whether Foveola renders what this glTF extension adds.
bool is_supported_extension(std::string_view name);

/// For a message: what a scene lacks without an extension that is not supported, after a colon;
/// empty where that is not known.
std::string what_is_lost_without(std::string_view name);

}  // namespace foveola
