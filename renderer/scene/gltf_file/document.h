// Parses and validates the JSON part of a glTF file.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace foveola {

/// The glTF 2.0 document in `json`, if Foveola supports it. Every property that the loader reads
/// has the type of the specification (Khronos, glTF 2.0.1), and every index refers to an element.
/// Every buffer view lies inside its buffer's stated length, and every required extension is known.
/// Whole numbers may be written as 1.0. Throws GltfFault.
nlohmann::json checked_gltf_document(std::string_view json);

/// Whether Foveola renders the content of this glTF extension.
bool is_supported_extension(std::string_view name);

/// For a message: the effect of an unsupported extension's absence, after a colon; empty if
/// unknown.
std::string what_is_lost_without(std::string_view name);

}  // namespace foveola
