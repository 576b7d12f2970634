#include <gmock/gmock.h>

#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string position_place = "meshes[0].primitives[0].attributes.POSITION: ";

/// A textured triangle whose texture coordinates are accessor `uv`.
void use_uvs(GlbBuilder& glb, int uv) {
  glb.document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = uv;
  glb.document["meshes"][0]["primitives"][0]["material"] = 0;
  const int texture = glb.add_texture(png(1, 1, 3, std::vector<std::uint8_t>{1, 2, 3}));
  glb.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
}

using Accessors = LoadGltf;

TEST_F(Accessors, ReadsInterleavedViews) {
  struct Vertex {
    Vec3 position;
    Vec3 normal;
    Vec2 uv;
  };
  const std::vector<Vertex> vertices = {{{0, 0, 0}, {0, 0, 1}, {0.25F, 0.5F}},
                                        {{1, 0, 0}, {0, 1, 0}, {0.75F, 0.5F}},
                                        {{0, 1, 0}, {1, 0, 0}, {0.25F, 1.5F}}};
  GlbBuilder glb;
  const int view = glb.add_view(vertices.data(), vertices.size() * sizeof(Vertex));
  glb.document["bufferViews"][view]["byteStride"] = sizeof(Vertex);
  const auto attribute = [&](std::size_t offset, const char* type) {
    return glb.add("accessors", {{"bufferView", view},
                                 {"byteOffset", offset},
                                 {"componentType", 5126},
                                 {"count", 3},
                                 {"type", type}});
  };
  const int positions = attribute(0, "VEC3");
  const int normals = attribute(offsetof(Vertex, normal), "VEC3");
  const int uvs = attribute(offsetof(Vertex, uv), "VEC2");
  glb.add_root(
      {{"mesh", glb.add_mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}})}});
  use_uvs(glb, uvs);
  const Mesh mesh = load(glb).meshes.at(0);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(mesh.positions[i], vertices[i].position);
    EXPECT_EQ(mesh.normals[i], vertices[i].normal);
    EXPECT_EQ(mesh.uv_sets.at(0)[i], vertices[i].uv);
  }
}

TEST_F(Accessors, NormalisesIntegerTextureCoordinates) {
  GlbBuilder bytes = one_triangle();
  const int bytes_accessor =
      bytes.add_accessor<std::uint8_t>({0, 255, 51, 102, 204, 153}, u8, "VEC2", 2);
  bytes.document["accessors"][bytes_accessor]["normalized"] = true;
  use_uvs(bytes, bytes_accessor);
  EXPECT_THAT(load(bytes).meshes.at(0).uv_sets.at(0),
              ElementsAre(Vec2(0, 1), Vec2(0.2F, 0.4F), Vec2(0.8F, 0.6F)));

  GlbBuilder words = one_triangle();
  const int words_accessor =
      words.add_accessor<std::uint16_t>({0, 65535, 13107, 26214, 0, 0}, u16, "VEC2", 2);
  words.document["accessors"][words_accessor]["normalized"] = true;
  use_uvs(words, words_accessor);
  EXPECT_THAT(load(words).meshes.at(0).uv_sets.at(0),
              ElementsAre(Vec2(0, 1), Vec2(0.2F, 0.4F), Vec2(0, 0)));
}

TEST_F(Accessors, RefusesOtherTypes) {
  GlbBuilder quantised = one_triangle();
  const int positions =
      quantised.add_accessor<std::uint16_t>({0, 0, 0, 1, 0, 0, 0, 1, 0}, u16, "VEC3", 3);
  quantised.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = positions;
  EXPECT_THAT(error_of(quantised),
              HasSubstr(position_place +
                        "accessors[1] holds 3 x 16-bit unsigned, but 3 x float is needed"));

  GlbBuilder plane = one_triangle();
  plane.document["accessors"][0]["type"] = "VEC2";
  EXPECT_THAT(error_of(plane), HasSubstr("accessors[0] holds 2 x float, but 3 x float is needed"));

  GlbBuilder indices = one_triangle();
  indices.document["meshes"][0]["primitives"][0]["indices"] = 0;
  EXPECT_THAT(error_of(indices), HasSubstr("meshes[0].primitives[0].indices: accessors[0] holds"));

  GlbBuilder uvs = one_triangle();
  use_uvs(uvs, uvs.add_accessor<std::uint8_t>({0, 0, 0, 0, 0, 0}, u8, "VEC2", 2));
  EXPECT_THAT(error_of(uvs),
              HasSubstr("attributes.TEXCOORD_0: accessors[1] holds 2 x 8-bit unsigned, but"));
}

TEST_F(Accessors, RefusesToReadBeyondTheView) {
  GlbBuilder glb = one_triangle();
  glb.document["accessors"][0]["count"] = 4;
  EXPECT_THAT(
      error_of(glb),
      HasSubstr(position_place + "accessors[0] ends at byte 48, but bufferViews[0] has 36 bytes"));

  glb.document["accessors"][0]["count"] = 3;
  glb.document["accessors"][0]["byteOffset"] = 4;
  EXPECT_THAT(error_of(glb), HasSubstr("accessors[0] ends at byte 40"));
}

TEST_F(Accessors, AnAbsurdCountCostsNothing) {
  GlbBuilder glb = one_triangle();
  glb.document["accessors"][0]["count"] = 4294967295U;
  EXPECT_THAT(error_of(glb), HasSubstr(position_place + "accessors[0] ends at byte 51539607540"));
  glb.document["bufferViews"][0]["byteStride"] = 252;
  EXPECT_THAT(error_of(glb), HasSubstr("accessors[0] ends at byte"));
}

TEST_F(Accessors, RefusesSparseOnes) {
  GlbBuilder glb = one_triangle();
  glb.document["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", 0}, {"componentType", 5123}}},
      {"values", {{"bufferView", 0}}}};
  EXPECT_THAT(error_of(glb),
              HasSubstr(position_place + "accessors[0] is sparse, which is not supported"));
}

TEST_F(Accessors, RefusesThoseWithoutAView) {
  GlbBuilder glb = one_triangle();
  glb.document["accessors"][0].erase("bufferView");
  EXPECT_THAT(error_of(glb), HasSubstr(position_place + "accessors[0] has no bufferView"));
}

}  // namespace
}  // namespace foveola::test
