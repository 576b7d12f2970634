#include <meshoptimizer.h>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

const std::vector<Vec3> square_positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<unsigned> square_corners = {0, 1, 2, 0, 2, 3};

using Encoded = std::vector<unsigned char>;

Encoded encoded_vertices(const void* vertices, std::size_t count, std::size_t stride) {
  Encoded bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), vertices, count, stride));
  return bytes;
}

Encoded encoded_triangles() {
  Encoded bytes(meshopt_encodeIndexBufferBound(square_corners.size(), square_positions.size()));
  bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), square_corners.data(),
                                         square_corners.size()));
  return bytes;
}

/// A buffer view in buffer 1, the fallback, whose content is `encoded`.
int add_compressed(GlbBuilder& glb, const Encoded& encoded, std::size_t count, std::size_t stride,
                   const char* mode, const char* filter = "NONE") {
  const int view = glb.add_view(encoded.data(), encoded.size());
  Json& item = glb.document["bufferViews"][view];
  Json compression = item;
  compression["byteStride"] = stride;
  compression["count"] = count;
  compression["mode"] = mode;
  compression["filter"] = filter;
  item = {{"buffer", 1},
          {"byteLength", count * stride},
          {"extensions", {{"EXT_meshopt_compression", compression}}}};
  return view;
}

int add_accessor_of(GlbBuilder& glb, int view, GlbComponent component, const char* type,
                    std::size_t count) {
  return glb.add("accessors", {{"bufferView", view},
                               {"componentType", static_cast<int>(component)},
                               {"type", type},
                               {"count", count}});
}

/// A square whose positions and indices are compressed.
GlbBuilder compressed_square() {
  GlbBuilder glb;
  const int positions =
      add_compressed(glb, encoded_vertices(square_positions.data(), 4, 12), 4, 12, "ATTRIBUTES");
  const int indices = add_compressed(glb, encoded_triangles(), 6, 4, "TRIANGLES");
  glb.add_root(
      {{"mesh", glb.add_mesh({{"attributes",
                               {{"POSITION", add_accessor_of(glb, positions, float32, "VEC3", 4)}}},
                              {"indices", add_accessor_of(glb, indices, uint32, "SCALAR", 6)}})}});
  glb.document["extensionsUsed"] = {"EXT_meshopt_compression"};
  glb.document["extensionsRequired"] = {"EXT_meshopt_compression"};
  glb.document["buffers"] = {
      {{"byteLength", glb.buffer.size()}},
      {{"byteLength", 72}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  return glb;
}

Json& compression_of(GlbBuilder& glb, int view) {
  return glb.document["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
}

using GltfMeshopt = LoadGltf;

TEST_F(GltfMeshopt, IsDecoded) {
  const Scene scene = load(compressed_square());
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_EQ(scene.meshes.at(0).positions, square_positions);
  EXPECT_EQ(scene.triangle_count(), 2U);
}

TEST_F(GltfMeshopt, ReadsNoFallback) {
  GlbBuilder glb = compressed_square();
  glb.document["buffers"][1]["uri"] = "gone.bin";
  EXPECT_EQ(load(glb).triangle_count(), 2U);
}

/// An octahedral normal along +Z, of 8 bits: x, y, and the 127 that stands for 1.
TEST_F(GltfMeshopt, AppliesFilters) {
  GlbBuilder glb = compressed_square();
  const std::vector<std::int8_t> encoded(16, 0);
  std::vector<std::int8_t> normals = encoded;
  for (std::size_t i = 2; i < normals.size(); i += 4) {
    normals[i] = 127;
  }
  const int view =
      add_compressed(glb, encoded_vertices(normals.data(), 4, 4), 4, 4, "ATTRIBUTES", "OCTAHEDRAL");
  glb.document["bufferViews"][view]["byteStride"] = 4;
  const int accessor = add_accessor_of(glb, view, int8, "VEC3", 4);
  glb.document["accessors"][accessor]["normalized"] = true;
  glb.primitive()["attributes"]["NORMAL"] = accessor;
  glb.document["buffers"][0]["byteLength"] = glb.buffer.size();
  EXPECT_THAT(load(glb).meshes.at(0).normals, Each(Vec3(0, 0, 1)));
}

/// 2^-1 * 3 and 2^2 * 1: an exponent in the upper 8 bits, a mantissa in the lower 24.
TEST_F(GltfMeshopt, AppliesTheExponentialFilter) {
  GlbBuilder glb = compressed_square();
  const std::uint32_t one_and_a_half = 0xFF000003U;
  const std::uint32_t four = 0x02000001U;
  const std::vector<std::uint32_t> values = {0, 0, 0, one_and_a_half, 0, 0, 0, four, 0, 0, 0, 0};
  const int view = add_compressed(glb, encoded_vertices(values.data(), 4, 12), 4, 12, "ATTRIBUTES",
                                  "EXPONENTIAL");
  glb.document["accessors"][0]["bufferView"] = view;
  glb.document["buffers"][0]["byteLength"] = glb.buffer.size();
  EXPECT_THAT(load(glb).meshes.at(0).positions,
              ElementsAre(Vec3(0, 0, 0), Vec3(1.5F, 0, 0), Vec3(0, 4, 0)));
}

TEST_F(GltfMeshopt, RefusesWhatTheExtensionForbids) {
  struct Wrong {
    int view;
    const char* property;
    Json value;
    const char* fault;
  };
  const std::vector<Wrong> cases = {
      {0, "byteStride", 6, "has a byteStride of 6 and a count of 4, which ATTRIBUTES cannot have"},
      {1, "count", 5, "has a byteStride of 4 and a count of 5, which TRIANGLES cannot have"},
      {1, "byteStride", 8, "has a byteStride of 8"},
      {0, "filter", "OCTAHEDRAL", "has the filter OCTAHEDRAL"},
      {1, "filter", "EXPONENTIAL", "has the filter EXPONENTIAL"},
      {0, "filter", "SECRET", "filter: must be one of NONE"},
      {0, "mode", "POINTS", "mode: must be one of ATTRIBUTES"},
      {0, "buffer", 9, "buffer: is 9, but buffers has 2 elements"},
      {0, "byteLength", 100000, "ends at byte 100000, but its buffer has"},
      {0, "count", 4294967295U, "would take 49152 MiB of memory"},
      {0, "count", 400, "the compressed data is damaged"}};
  for (const Wrong& wrong : cases) {
    GlbBuilder glb = compressed_square();
    compression_of(glb, wrong.view)[wrong.property] = wrong.value;
    EXPECT_THAT(error_of(glb), HasSubstr(wrong.fault)) << wrong.property;
  }
}

/// Either a scene or an Error.
TEST_F(GltfMeshopt, SurvivesOtherBytes) {
  for (std::size_t i = 0; i < compressed_square().buffer.size(); ++i) {
    GlbBuilder glb = compressed_square();
    glb.buffer[i] = static_cast<char>(glb.buffer[i] ^ (1 << i % 8));
    try {
      load(glb);
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace foveola::test
