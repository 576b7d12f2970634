#include "renderer/glb/glb_document.h"

#include <array>

#include <gtest/gtest.h>

namespace foveola {
namespace {

using Document = GlbDocument<nlohmann::ordered_json>;

// glTF 2.0 specification, section 4.4: a header of 12 bytes, and chunks of whole words.
TEST(GlbDocument, ContainerIsPaddedToWholeWords) {
  EXPECT_EQ(glb_container("{}", ""), std::string("glTF\x02\0\0\0\x18\0\0\0\x04\0\0\0JSON{}  ", 24));
  EXPECT_EQ(
      glb_container("{  }", "abcde"),
      std::string("glTF\x02\0\0\0\x28\0\0\0\x04\0\0\0JSON{  }\x08\0\0\0BIN\0abcde\0\0\0", 40));
}

TEST(GlbDocument, ViewsBeginAtWholeWords) {
  constexpr std::array<std::byte, 3> bytes{};
  Document glb;
  EXPECT_EQ(glb.add_view(bytes), 0);
  EXPECT_EQ(glb.add_accessor(bytes, GlbComponent::uint8, "SCALAR", 3, GlbTarget::indices), 0);
  EXPECT_EQ(glb.document["bufferViews"][1].dump(),
            R"({"buffer":0,"byteOffset":4,"byteLength":3,"target":34963})");
  EXPECT_EQ(glb.document["accessors"][0].dump(),
            R"({"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"})");
}

TEST(GlbDocument, RootsAreNodesOfTheFirstScene) {
  Document glb;
  glb.add("nodes", {{"name", "child"}});
  EXPECT_EQ(glb.add_root({{"name", "root"}}), 1);
  EXPECT_EQ(glb.document["scenes"].dump(), R"([{"nodes":[1]}])");
}

TEST(GlbDocument, TheBufferIsListedUnlessTheDocumentListsOthers) {
  Document glb;
  glb.buffer = "abc";
  EXPECT_EQ(glb.bytes(), glb_container(R"({"buffers":[{"byteLength":4}]})", "abc"));
  glb.document["buffers"] = nlohmann::ordered_json::array();
  EXPECT_EQ(glb.bytes(), glb_container(R"({"buffers":[]})", "abc"));
}

}  // namespace
}  // namespace foveola
