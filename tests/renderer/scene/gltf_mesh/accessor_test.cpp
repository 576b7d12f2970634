#include <array>
#include <cmath>

#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

const std::string position_place = "meshes[0].primitives[0].attributes.POSITION: ";

/// A textured triangle whose texture coordinates are accessor `uv`.
void use_uvs(GlbBuilder& glb, int uv) {
  glb.primitive()["attributes"]["TEXCOORD_0"] = uv;
  glb.primitive()["material"] = 0;
  const int texture = glb.add_texture(one_pixel(1, 2, 3));
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

class AccessorTypes : public LoadGltf {
 protected:
  /// The first set of texture coordinates of a triangle that stores them like this.
  template <typename T>
  std::vector<Vec2> uvs(const std::vector<T>& values, GlbComponent type, bool normalized) const {
    GlbBuilder glb = one_triangle();
    const int accessor = glb.add_accessor(values, type, "VEC2", 2);
    glb.document["accessors"][accessor]["normalized"] = normalized;
    use_uvs(glb, accessor);
    return load(glb).meshes.at(0).uv_sets.at(0);
  }
};

/// KHR_mesh_quantization's table: f = c / 127, c / 255, c / 32767 or c / 65535, and not below -1.
TEST_F(AccessorTypes, NormalisesIntegers) {
  EXPECT_THAT(uvs<std::uint8_t>({0, 255, 51, 102, 204, 153}, uint8, true),
              ElementsAre(Vec2(0, 1), Vec2(0.2F, 0.4F), Vec2(0.8F, 0.6F)));
  EXPECT_THAT(uvs<std::uint16_t>({0, 65535, 13107, 26214, 0, 0}, uint16, true),
              ElementsAre(Vec2(0, 1), Vec2(0.2F, 0.4F), Vec2(0, 0)));
  EXPECT_THAT(uvs<std::int8_t>({127, -127, -128, 0, 1, 0}, int8, true),
              ElementsAre(Vec2(1, -1), Vec2(-1, 0), Vec2(1.0F / 127.0F, 0)));
  EXPECT_THAT(uvs<std::int16_t>({32767, -32767, -32768, 0, 1, 0}, int16, true),
              ElementsAre(Vec2(1, -1), Vec2(-1, 0), Vec2(1.0F / 32767.0F, 0)));
}

TEST_F(AccessorTypes, TakesOtherIntegersAsTheyAre) {
  EXPECT_THAT(uvs<std::uint8_t>({0, 255, 51, 102, 204, 153}, uint8, false),
              ElementsAre(Vec2(0, 255), Vec2(51, 102), Vec2(204, 153)));
  EXPECT_THAT(uvs<std::int16_t>({32767, -32768, 0, 0, 1, 0}, int16, false),
              ElementsAre(Vec2(32767, -32768), Vec2(0, 0), Vec2(1, 0)));
}

/// Shorts at a stride of 8 bytes, scaled by the node; normals in bytes at a stride of 4.
TEST_F(Accessors, ReadsQuantisedMeshes) {
  GlbBuilder glb;
  const std::vector<std::int16_t> positions = {-100, 0, 0, 9, 100, 0, 0, 9, 0, 100, 50, 9};
  const std::vector<std::int8_t> normals = {0, 0, 127, 9, 0, 0, 127, 9, 0, 90, 90, 9};
  const int position = glb.add_accessor(positions, int16, "VEC3", 4);
  const int normal = glb.add_accessor(normals, int8, "VEC3", 4);
  glb.document["bufferViews"][0]["byteStride"] = 8;
  glb.document["bufferViews"][1]["byteStride"] = 4;
  glb.document["accessors"][normal]["normalized"] = true;
  glb.document["extensionsUsed"] = {"KHR_mesh_quantization"};
  glb.document["extensionsRequired"] = {"KHR_mesh_quantization"};
  const int mesh = glb.add_mesh({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}});
  glb.add_root({{"mesh", mesh}, {"scale", {0.01, 0.01, 0.01}}});
  const Scene scene = load(glb);
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_THAT(scene.meshes.at(0).positions,
              ElementsAre(Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0.5F)));
  EXPECT_EQ(scene.meshes[0].normals[0], Vec3(0, 0, 1));
  EXPECT_NEAR(scene.meshes[0].normals[2].y, std::sqrt(0.5F), 1e-6F);
}

TEST_F(Accessors, RefusesOtherTypes) {
  GlbBuilder wide = one_triangle();
  wide.primitive()["attributes"]["POSITION"] =
      wide.add_accessor<std::uint32_t>({0, 0, 0, 1, 0, 0, 0, 1, 0}, uint32, "VEC3", 3);
  EXPECT_THAT(error_of(wide),
              HasSubstr(position_place + "accessors[1] holds 3 x 32-bit unsigned, but 3 x float or "
                                         "integer of 8 or 16 bits is needed"));

  GlbBuilder plane = one_triangle();
  plane.document["accessors"][0]["type"] = "VEC2";
  EXPECT_THAT(error_of(plane), HasSubstr("accessors[0] holds 2 x float, but 3 x float or"));

  GlbBuilder indices = one_triangle();
  indices.primitive()["indices"] = 0;
  EXPECT_THAT(error_of(indices), HasSubstr("meshes[0].primitives[0].indices: accessors[0] holds"));

  GlbBuilder colors = one_triangle();
  colors.primitive()["attributes"]["COLOR_0"] =
      colors.add_accessor<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0}, uint8, "VEC3", 3);
  EXPECT_THAT(error_of(colors),
              HasSubstr("attributes.COLOR_0: accessors[1] holds 3 x 8-bit unsigned, but float or"));
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

/// One triangle some of whose positions are replaced.
GlbBuilder sparse(const std::vector<std::uint16_t>& indices, const std::vector<Vec3>& values) {
  GlbBuilder glb = one_triangle();
  const int index_view = glb.add_view(indices.data(), indices.size() * sizeof(std::uint16_t));
  const int value_view = glb.add_view(values.data(), values.size() * sizeof(Vec3));
  glb.document["accessors"][0]["sparse"] = {
      {"count", indices.size()},
      {"indices", {{"bufferView", index_view}, {"componentType", static_cast<int>(uint16)}}},
      {"values", {{"bufferView", value_view}}}};
  return glb;
}

TEST_F(Accessors, SparseOnesReplaceElements) {
  const std::vector<Vec3> values = {{7, 0, 0}, {0, 9, 0}};
  EXPECT_THAT(load(sparse({1, 2}, values)).meshes.at(0).positions,
              ElementsAre(Vec3(0, 0, 0), Vec3(7, 0, 0), Vec3(0, 9, 0)));
}

TEST_F(Accessors, SparseOnesWithoutAViewAreZeroElsewhere) {
  GlbBuilder glb = sparse({1, 2}, {{7, 0, 0}, {0, 9, 0}});
  glb.document["accessors"][0].erase("bufferView");
  EXPECT_THAT(load(glb).meshes.at(0).positions,
              ElementsAre(Vec3(0, 0, 0), Vec3(7, 0, 0), Vec3(0, 9, 0)));
}

TEST_F(Accessors, SparseOffsetsCountFromTheirViews) {
  GlbBuilder glb = sparse({5, 5, 2}, {{5, 5, 5}, {0, 9, 0}});
  Json& replaced = glb.document["accessors"][0]["sparse"];
  replaced["count"] = 1;
  replaced["indices"]["byteOffset"] = 4;
  replaced["values"]["byteOffset"] = 12;
  EXPECT_THAT(load(glb).meshes.at(0).positions,
              ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 9, 0)));
}

TEST_F(Accessors, IndicesMayBeSparse) {
  GlbBuilder glb = one_triangle();
  const int accessor = glb.add_accessor<std::uint8_t>({0, 0, 2}, uint8, "SCALAR", 1);
  const std::vector<std::uint8_t> bytes = {1, 1};
  const int view = glb.add_view(bytes.data(), 2);
  glb.document["accessors"][accessor]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", view}, {"componentType", static_cast<int>(uint8)}}},
      {"values", {{"bufferView", view}, {"byteOffset", 1}}}};
  glb.primitive()["indices"] = accessor;
  EXPECT_THAT(load(glb).meshes.at(0).triangles, ElementsAre(std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST_F(Accessors, SparseIndicesNeedNoBufferView) {
  GlbBuilder glb = one_triangle();
  const std::vector<std::uint8_t> bytes = {1, 2};  // which elements are replaced, and by what
  const Json part = {{"bufferView", glb.add_view(bytes.data(), bytes.size())},
                     {"componentType", static_cast<int>(uint8)}};
  glb.primitive()["indices"] =
      glb.add("accessors", {{"componentType", static_cast<int>(uint8)},
                            {"count", 3},
                            {"type", "SCALAR"},
                            {"sparse", {{"count", 2}, {"indices", part}, {"values", part}}}});
  EXPECT_THAT(load(glb).meshes.at(0).triangles, ElementsAre(std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST_F(Accessors, RefusesSparseIndicesOutOfRangeOrOrder) {
  const std::vector<Vec3> values = {{7, 0, 0}, {0, 9, 0}};
  EXPECT_THAT(error_of(sparse({1, 3}, values)),
              HasSubstr("accessors[0].sparse.indices: name element 3 after 1, of 3"));
  EXPECT_THAT(error_of(sparse({2, 1}, values)), HasSubstr("name element 1 after 2, of 3"));
  EXPECT_THAT(error_of(sparse({1, 1}, values)), HasSubstr("name element 1 after 1, of 3"));
}

TEST_F(Accessors, RefusesSparseDataBeyondTheirViews) {
  GlbBuilder values = sparse({1, 2}, {{7, 0, 0}});
  EXPECT_THAT(error_of(values), HasSubstr("accessors[0].sparse.values ends at byte 24, but "
                                          "bufferViews[2] has 12 bytes"));
  GlbBuilder indices = sparse({1, 2}, {{7, 0, 0}, {0, 9, 0}});
  indices.document["accessors"][0]["sparse"]["indices"]["byteOffset"] = 2;
  EXPECT_THAT(error_of(indices), HasSubstr("accessors[0].sparse.indices ends at byte 6, but "
                                           "bufferViews[1] has 4 bytes"));
}

/// Zeros take no bytes in a file, but four billion of them take 48 GiB of memory.
TEST_F(Accessors, RefusesZerosBeyondAllMeasure) {
  GlbBuilder glb = sparse({1, 2}, {{7, 0, 0}, {0, 9, 0}});
  glb.document["accessors"][0].erase("bufferView");
  glb.document["accessors"][0]["count"] = 4294967295U;
  EXPECT_THAT(error_of(glb), HasSubstr(position_place + "accessors[0] has 4294967295 elements "
                                                        "without data; up to 4194304 are read"));
}

TEST_F(Accessors, ThoseWithoutAViewAreZero) {
  GlbBuilder glb = one_triangle();
  use_uvs(glb, glb.add("accessors", {{"componentType", 5126}, {"count", 3}, {"type", "VEC2"}}));
  EXPECT_THAT(load(glb).meshes.at(0).uv_sets.at(0),
              ElementsAre(Vec2(0, 0), Vec2(0, 0), Vec2(0, 0)));
  glb.document["accessors"][0].erase("bufferView");
  EXPECT_THAT(load(glb).warnings, ElementsAre(HasSubstr("triangles without area"),
                                              HasSubstr("the scene has no triangles")));
}

}  // namespace
}  // namespace foveola::test
