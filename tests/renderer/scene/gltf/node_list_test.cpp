#include "renderer/scene/gltf/node_list.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foveola {
namespace {

/// tinygltf itself is who says how a node is to be read.
TEST(GltfNodeList, IsWhatTinygltfReads) {
  const auto document = nlohmann::json::parse(R"({"asset": {"version": "2.0"}, "nodes": [
      {},
      {"name": "all", "children": [2, 3], "mesh": 4, "camera": 5, "skin": 6, "weights": [0.25, 1],
       "translation": [1, 2.5, 3], "rotation": [0, 0, 0, 1], "scale": [1, 1, 2],
       "extensions": {"EXT_any": {"whole": 7, "minus": -7, "number": 0.5, "text": "t", "truth": true,
                                  "list": [1, [2.5]], "object": {"light": 8}}}},
      {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1], "scale": [2, 2, 2]}]})");
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const std::string text = document.dump();
  ASSERT_TRUE(tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, text.data(),
                                                       static_cast<unsigned>(text.size()), ""))
      << error;
  const std::vector<tinygltf::Node> nodes = node_list_of(document["nodes"]);
  ASSERT_EQ(nodes.size(), 3U);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_TRUE(nodes[i] == model.nodes[i]) << i;
  }
}

}  // namespace
}  // namespace foveola
