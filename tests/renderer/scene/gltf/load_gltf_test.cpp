#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/numbers/random.h"
#include "renderer/scene/load_scene.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

/// A material with a texture, and factors that need it, in every place.
Json rich_material(int texture) {
  const Json plain = {{"index", texture}};
  const Json moved = {
      {"index", texture},
      {"texCoord", 1},
      {"extensions",
       {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"rotation", 0.5}, {"scale", {2, 2}}}}}}};
  return {
      {"name", "leaf"},
      {"alphaMode", "MASK"},
      {"emissiveFactor", {1, 1, 1}},
      {"emissiveTexture", plain},
      {"normalTexture", moved},
      {"extensions",
       {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2.5}}},
        {"KHR_materials_ior", {{"ior", 1.4}}},
        {"KHR_materials_transmission",
         {{"transmissionFactor", 0.5}, {"transmissionTexture", moved}}},
        {"KHR_materials_volume",
         {{"thicknessFactor", 1}, {"attenuationDistance", 2}, {"attenuationColor", {1, 1, 0}}}},
        {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}, {"clearcoatTexture", plain}}},
        {"KHR_materials_sheen", {{"sheenColorFactor", {1, 1, 1}}, {"sheenColorTexture", plain}}}}},
      {"pbrMetallicRoughness", {{"baseColorTexture", plain}}}};
}

/// A file that uses most of what can be read: nodes, indices, all vertex attributes, sparse and
/// quantised accessors, textures, a strip, a camera, a light and instances.
GlbBuilder rich_scene() {
  GlbBuilder glb;
  const int positions = glb.add_vectors({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  const int normals = glb.add_vectors(std::vector<Vec3>(4, {0, 0, 1}));
  const int first_uvs = glb.add_uvs({{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  const int second_uvs = glb.add_accessor<std::int16_t>({0, 0, 9, 0, 0, 9, 9, 9}, int16, "VEC2", 2);
  const int colors = glb.add_accessor(std::vector<std::uint8_t>(16, 99), uint8, "VEC4", 4);
  glb.document["accessors"][colors]["normalized"] = true;
  const int indices = glb.add_accessor<std::uint16_t>({0, 1, 2, 2, 1, 3}, uint16, "SCALAR", 1);
  const std::vector<std::uint8_t> replaced = {1, 3};
  const std::vector<Vec3> replacements = {{1, 0, 0}, {1, 1, 0}};
  glb.document["accessors"][positions]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", glb.add_view(replaced.data(), 2)}, {"componentType", 5121}}},
      {"values", {{"bufferView", glb.add_view(replacements.data(), 2 * sizeof(Vec3))}}}};
  const int texture = glb.add_texture(png(4, 4, 4, std::vector<std::uint8_t>(64, 99)));
  glb.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"minFilter", 9729}});
  glb.document["textures"][texture]["sampler"] = 0;
  glb.add("materials", rich_material(texture));
  const Json attributes = {{"POSITION", positions},
                           {"NORMAL", normals},
                           {"TEXCOORD_0", first_uvs},
                           {"TEXCOORD_1", second_uvs},
                           {"COLOR_0", colors}};
  glb.add_mesh({{"attributes", attributes}, {"indices", indices}, {"material", 0}});
  glb.add_mesh({{"attributes", {{"POSITION", positions}}}, {"mode", 5}});
  glb.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  glb.document["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"intensity", 3}, {"spot", {{"innerConeAngle", 0.1}}}}};
  glb.add("nodes", {{"mesh", 0}, {"rotation", {0, 0, 0, 1}}, {"scale", {1, -2, 1}}});
  glb.add_root({{"children", {0}}, {"translation", {1, 2, 3}}});
  glb.add_root(
      {{"mesh", 1}, {"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  return glb;
}

TEST_F(LoadGltf, LoadsTheRichScene) {
  const Scene scene = load(rich_scene());
  EXPECT_EQ(scene.triangle_count(), 4U);
  EXPECT_EQ(scene.textures.size(), 3U) << "of colours with opacity, of colours, of numbers";
  EXPECT_EQ(scene.cameras.size(), 1U);
  EXPECT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.meshes.at(0).uv_sets.size(), 2U);
  EXPECT_EQ(scene.meshes[0].tangents.size(), 4U);
  EXPECT_EQ(scene.meshes[0].colors.size(), 4U);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.bounds().lower, Vec3(0, 0, 0));
  EXPECT_EQ(scene.bounds().upper, Vec3(2, 2, 3));
}

TEST_F(LoadGltf, ErrorsNameTheFileThePlaceAndARemedy) {
  GlbBuilder glb = one_triangle();
  glb.primitive()["attributes"]["POSITION"] = 5;
  const std::string path = (folder() / "scene.glb").string();
  EXPECT_EQ(error_of(glb), path +
                               ": meshes[0].primitives[0].attributes.POSITION: is 5, but accessors "
                               "has 1 elements; export it again, or look at it with a glTF "
                               "validator");
}

template <typename T>
bool is_absent_or_of(std::size_t size, const std::vector<T>& list) {
  return list.empty() || list.size() == size;
}

void expect_usable(const Mesh& mesh, const Scene& scene) {
  const std::size_t vertices = mesh.positions.size();
  ASSERT_LT(static_cast<std::size_t>(mesh.material), scene.materials.size());
  EXPECT_TRUE(is_absent_or_of(vertices, mesh.normals));
  EXPECT_TRUE(is_absent_or_of(vertices, mesh.tangents));
  EXPECT_TRUE(is_absent_or_of(vertices, mesh.colors));
  for (const std::vector<Vec2>& uvs : mesh.uv_sets) {
    EXPECT_EQ(uvs.size(), vertices);
  }
  const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
  for (const TextureUse& use :
       {material.base_color_texture, material.metallic_roughness_texture, material.normal_texture,
        material.emissive_texture, material.transmission_texture, material.clearcoat_texture,
        material.sheen_color_texture}) {
    EXPECT_LT(use.texture, static_cast<int>(scene.textures.size()));
    if (use.exists() && !mesh.uv_sets.empty()) {
      EXPECT_LT(use.uv_set, static_cast<int>(mesh.uv_sets.size()));
    }
  }
  for (const Vec4& tangent : mesh.tangents) {
    EXPECT_NEAR(glm::length(Vec3(tangent)), 1.0F, 1e-3F);
  }
  for (const Vec3& normal : mesh.normals) {
    EXPECT_NEAR(glm::length(normal), 1.0F, 1e-3F);
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      ASSERT_LT(vertex, vertices);
      EXPECT_TRUE(is_finite(mesh.positions[vertex]));
    }
  }
}

/// Either a scene in which nothing is out of range, or an Error: nothing else, and no crash.
void expect_scene_or_error(const std::filesystem::path& path, const std::string& mutation) {
  SCOPED_TRACE(mutation);
  try {
    const Scene scene = load_gltf(path);
    for (const Mesh& mesh : scene.meshes) {
      expect_usable(mesh, scene);
    }
    for (const Mesh& mesh : scene.prototypes) {
      expect_usable(mesh, scene);
    }
    for (const Instance& instance : scene.instances) {
      EXPECT_LT(instance.prototype, scene.prototypes.size());
    }
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(path.filename().string()));
  } catch (const std::exception& other) {
    ADD_FAILURE() << other.what();
  }
}

TEST_F(LoadGltf, SurvivesFlippedBytes) {
  const std::string whole = rich_scene().bytes();
  Pcg32 random(1);
  for (int i = 0; i < 3000; ++i) {
    std::string spoilt = whole;
    const std::uint32_t flips = 1 + random.below(4);
    std::string mutation = "flipped";
    for (std::uint32_t k = 0; k < flips; ++k) {
      const std::uint32_t at = random.below(static_cast<std::uint32_t>(whole.size()));
      spoilt[at] = static_cast<char>(random.below(256));
      mutation += fmt::format(" {}", at);
    }
    expect_scene_or_error(write("spoilt.glb", spoilt), mutation);
  }
}

/// Digits decide indices, counts and offsets, which random bytes rarely reach.
TEST_F(LoadGltf, SurvivesOtherNumbers) {
  const GlbBuilder glb = rich_scene();
  Json complete = glb.document;
  complete["buffers"] = {{{"byteLength", glb.buffer.size()}}};
  const std::string json = complete.dump();
  std::vector<std::size_t> digits;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (json[i] >= '0' && json[i] <= '9') {
      digits.push_back(i);
    }
  }
  Pcg32 random(2);
  for (int i = 0; i < 2000; ++i) {
    std::string spoilt = json;
    const std::size_t at = digits[random.below(static_cast<std::uint32_t>(digits.size()))];
    static const std::vector<std::string> numbers = {
        "0",    "1",   "2",   "7", "-1", "255", "4095", "4294967295", "18446744073709551615",
        "1e40", "0.5", "null"};
    const std::string& number = numbers[random.below(static_cast<std::uint32_t>(numbers.size()))];
    spoilt.replace(at, 1, number);
    expect_scene_or_error(write("spoilt.glb", glb_container(spoilt, glb.buffer)),
                          fmt::format("byte {} is {}", at, number));
  }
}

TEST_F(LoadGltf, SurvivesTruncationWithAFittingHeader) {
  const std::string whole = rich_scene().bytes();
  for (std::size_t size = 12; size < whole.size(); ++size) {
    std::string cut = whole.substr(0, size);
    const auto length = static_cast<std::uint32_t>(size);
    std::memcpy(cut.data() + 8, &length, 4);
    EXPECT_THAT(error_of_bytes(cut), HasSubstr("scene.glb"));
  }
}

}  // namespace
}  // namespace foveola::test
