#include <algorithm>
#include <array>
#include <tuple>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"
#include "tests/renderer/scene/gltf_mesh/draco_square.h"

namespace foveola::test {
namespace {

/// A file that holds `encoded`, with a material that shows texture coordinates.
GlbBuilder with_draco(const std::string& encoded) {
  GlbBuilder glb = with_material(Json::object());
  glb.document["materials"][0] = textured(glb.add_texture(one_pixel(1, 2, 3)));
  const int view = glb.add_view(encoded.data(), encoded.size());
  const auto accessor = [&](GlbComponent component, const char* type, int count) {
    return glb.add(
        "accessors",
        {{"componentType", static_cast<int>(component)}, {"type", type}, {"count", count}});
  };
  const Json compression = {{"bufferView", view},
                            {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}};
  glb.primitive() = {
      {"attributes",
       {{"POSITION", accessor(float32, "VEC3", 4)}, {"TEXCOORD_0", accessor(float32, "VEC2", 4)}}},
      {"indices", accessor(uint16, "SCALAR", 6)},
      {"material", 0},
      {"extensions", {{"KHR_draco_mesh_compression", compression}}}};
  glb.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  glb.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return glb;
}

bool comes_before(const Vec3& a, const Vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

constexpr std::array methods = {DracoMethod::sequential, DracoMethod::edgebreaker};

using GltfDraco = LoadGltf;

TEST_F(GltfDraco, IsDecoded) {
  for (const DracoMethod method : methods) {
    const Scene scene = load(with_draco(draco_square(method)));
    EXPECT_THAT(scene.warnings, IsEmpty());
    EXPECT_EQ(scene.triangle_count(), 2U);
    Mesh mesh = scene.meshes.at(0);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      EXPECT_EQ(Vec2(mesh.positions[i]), mesh.uv_sets.at(0)[i]) << "the square's coordinates";
    }
    std::sort(mesh.positions.begin(), mesh.positions.end(), comes_before);
    EXPECT_THAT(mesh.positions,
                ElementsAre(Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)));
  }
}

TEST_F(GltfDraco, NeedsNoIndices) {
  GlbBuilder glb = with_draco(draco_square(methods[0]));
  glb.primitive().erase("indices");
  EXPECT_EQ(load(glb).triangle_count(), 2U);
}

TEST_F(GltfDraco, RefusesMoreThanItsAccessorsState) {
  for (const DracoMethod method : methods) {
    GlbBuilder glb = with_draco(draco_square(method));
    const auto accessor = glb.primitive()["indices"].get<std::size_t>();
    glb.document["accessors"][accessor]["count"] = 3;
    EXPECT_THAT(error_of(glb), HasSubstr("KHR_draco_mesh_compression: has 4 vertices and 2 "
                                         "triangles, more than the 4 and 1 that its accessors"));
  }
  GlbBuilder glb = with_draco(draco_square(methods[0]));
  for (const auto& [name, accessor] : glb.primitive()["attributes"].items()) {
    glb.document["accessors"][accessor.get<std::size_t>()]["count"] = 3;
  }
  EXPECT_THAT(error_of(glb), HasSubstr("has 4 vertices and 2 triangles, more than the 3 and 2"));
}

TEST_F(GltfDraco, RefusesToTakeMuchMemoryForFewBytes) {
  GlbBuilder glb = with_draco(draco_square(methods[0]));
  const auto accessor = glb.primitive()["indices"].get<std::size_t>();
  glb.document["accessors"][accessor]["count"] = 4294967295U;
  EXPECT_THAT(error_of(glb), HasSubstr("KHR_draco_mesh_compression: would take 174763 MiB"));
}

TEST_F(GltfDraco, RefusesAttributesThatItDoesNotHave) {
  GlbBuilder glb = with_draco(draco_square(methods[0]));
  glb.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 7;
  EXPECT_THAT(error_of(glb), HasSubstr("names attribute 7, which the mesh does not have"));
  glb.primitive()["attributes"].erase("POSITION");
  EXPECT_THAT(error_of(glb), HasSubstr("has no accessor for POSITION"));
}

TEST_F(GltfDraco, RefusesWhatIsCutOffOrNone) {
  EXPECT_THAT(error_of(with_draco("DRACO is a dragon")), HasSubstr("holds no Draco mesh"));
  for (const DracoMethod method : methods) {
    const std::string whole = draco_square(method);
    for (std::size_t size = 1; size + 1 < whole.size(); ++size) {
      EXPECT_THAT(error_of(with_draco(whole.substr(0, size))),
                  HasSubstr("meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: "))
          << size;
    }
  }
}

/// Either a scene or an Error.
TEST_F(GltfDraco, SurvivesOtherBytes) {
  for (const DracoMethod method : methods) {
    const std::string whole = draco_square(method);
    for (std::size_t i = 0; i < 8 * whole.size(); ++i) {
      std::string spoilt = whole;
      spoilt[i / 8] = static_cast<char>(spoilt[i / 8] ^ (1 << i % 8));
      try {
        load(with_draco(spoilt));
      } catch (const Error&) {
      }
    }
  }
}

}  // namespace
}  // namespace foveola::test
