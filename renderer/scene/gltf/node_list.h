// A glTF document's nodes as tinygltf has them, read without tinygltf: that would write all of the
// text anew and parse it once more, which takes most of the time for a scene of many nodes.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>
#include <tiny_gltf.h>

namespace foveola {

/// nodes: the array of a checked document (see checked_gltf_document). A node with a matrix has no
/// translation, rotation and scale; extras are left out.
std::vector<tinygltf::Node> node_list_of(const nlohmann::json& nodes);

}  // namespace foveola
