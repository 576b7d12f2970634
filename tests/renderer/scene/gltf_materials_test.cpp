#include <gmock/gmock.h>

#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Json plain = Json::object();

/// A triangle whose only material is `material`, with both sets of texture coordinates.
GlbBuilder with_material(const Json& material) {
  GlbBuilder glb = one_triangle();
  const int first = glb.add_uvs({{0, 0}, {1, 0}, {0, 1}});
  const int second = glb.add_uvs({{5, 5}, {6, 5}, {5, 6}});
  Json& primitive = glb.document["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = first;
  primitive["attributes"]["TEXCOORD_1"] = second;
  primitive["material"] = glb.add("materials", material);
  return glb;
}

/// The parts of a material that have a base colour texture.
Json textured(int texture, int uv_set = 0) {
  return {
      {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}, {"texCoord", uv_set}}}}}};
}

std::string one_pixel(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  return png(1, 1, 3, std::vector<std::uint8_t>{red, green, blue});
}

class GltfMaterials : public LoadGltf {
 protected:
  /// The warnings of the scene, and its only material.
  std::pair<Material, std::vector<std::string>> read(const Json& material) const {
    const Scene scene = load(with_material(material));
    EXPECT_EQ(scene.materials.size(), 1U);
    return {scene.materials.at(0), scene.warnings};
  }
};

/// Specification, section 5.22: everything is 1.
TEST_F(GltfMaterials, AbsentFactorsAreTheSpecifications) {
  const auto [material, warnings] = read({{"name", "plain"}});
  EXPECT_EQ(material.name, "plain");
  EXPECT_EQ(material.base_color, Rgb(1.0F));
  EXPECT_EQ(material.alpha, 1.0F);
  EXPECT_EQ(material.metallic, 1.0F);
  EXPECT_EQ(material.roughness, 1.0F);
  EXPECT_EQ(material.emission, Rgb(0.0F));
  EXPECT_FALSE(material.double_sided);
  EXPECT_FALSE(material.is_cut_out());
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(GltfMaterials, APrimitiveWithoutOneHasTheDefault) {
  GlbBuilder glb = with_material({{"name", "unused"}});
  glb.document["meshes"][0]["primitives"][0].erase("material");
  const Scene scene = load(glb);
  ASSERT_EQ(scene.materials.size(), 2U);
  EXPECT_EQ(scene.meshes.at(0).material, 1);
  EXPECT_EQ(scene.materials[1].base_color, Rgb(1.0F));
  EXPECT_EQ(scene.materials[1].metallic, 1.0F);
}

TEST_F(GltfMaterials, ReadsFactors) {
  const auto [material, warnings] = read({{"doubleSided", true},
                                          {"pbrMetallicRoughness",
                                           {{"baseColorFactor", {0.25, 0.5, 0.75, 0.125}},
                                            {"metallicFactor", 0.25},
                                            {"roughnessFactor", 0.5}}}});
  EXPECT_EQ(material.base_color, Rgb(0.25F, 0.5F, 0.75F));
  EXPECT_EQ(material.alpha, 0.125F);
  EXPECT_EQ(material.metallic, 0.25F);
  EXPECT_EQ(material.roughness, 0.5F);
  EXPECT_TRUE(material.double_sided);
}

TEST_F(GltfMaterials, LimitsFactorsWithAWarning) {
  const auto [material, warnings] = read({{"pbrMetallicRoughness",
                                           {{"baseColorFactor", {1.5, -0.5, 0.5, 1}},
                                            {"metallicFactor", 2},
                                            {"roughnessFactor", -1}}}});
  EXPECT_EQ(material.base_color, Rgb(1.0F, 0.0F, 0.5F));
  EXPECT_EQ(material.metallic, 1.0F);
  EXPECT_EQ(material.roughness, 0.0F);
  EXPECT_THAT(warnings,
              ElementsAre("a base colour is limited to the range it may have "
                          "(materials[0].pbrMetallicRoughness.baseColorFactor)",
                          HasSubstr("a metallic factor"), HasSubstr("a roughness factor")));
}

TEST_F(GltfMaterials, EmissiveStrengthMultiplies) {
  const Json extension = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 12.5}}}};
  const auto [lamp, warnings] = read({{"emissiveFactor", {1, 0.5, 0}}, {"extensions", extension}});
  EXPECT_EQ(lamp.emission, Rgb(12.5F, 6.25F, 0.0F));
  EXPECT_TRUE(lamp.is_emissive());
  EXPECT_EQ(read({{"emissiveFactor", {1, 0.5, 0}}}).first.emission, Rgb(1.0F, 0.5F, 0.0F));
}

TEST_F(GltfMaterials, MaskCutsOutBelowItsCutoff) {
  GlbBuilder glb = with_material(plain);
  Json material = textured(glb.add_texture(one_pixel(1, 2, 3)));
  material["alphaMode"] = "MASK";
  glb.document["materials"][0] = material;
  EXPECT_EQ(load(glb).materials.at(0).alpha_cutoff, 0.5F) << "the specification's default";
  glb.document["materials"][0]["alphaCutoff"] = 0.25;
  EXPECT_EQ(load(glb).materials.at(0).alpha_cutoff, 0.25F);
}

TEST_F(GltfMaterials, AUniformSurfaceIsOpaqueOrCutOutWhole) {
  const auto mask = [&](double alpha) {
    return read({{"alphaMode", "MASK"},
                 {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, alpha}}}}})
        .first;
  };
  EXPECT_FALSE(mask(0.5).is_cut_out()) << "0.5 is not below the cutoff";
  EXPECT_TRUE(mask(0.25).is_cut_out());
}

TEST_F(GltfMaterials, BlendIsACutOutWithAWarning) {
  const auto [material, warnings] =
      read({{"alphaMode", "BLEND"},
            {"alphaCutoff", 0.1},
            {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.25}}}}});
  EXPECT_EQ(material.alpha_cutoff, 0.5F);
  EXPECT_THAT(warnings,
              ElementsAre("alpha blending is shown as a cut-out at alpha 0.5 (materials[0])"));
}

TEST_F(GltfMaterials, ColoursAreSrgbAndFactorsLinear) {
  GlbBuilder glb = with_material(plain);
  const int texture = glb.add_texture(one_pixel(188, 188, 188));
  glb.document["materials"][0] = {{"emissiveFactor", {1, 1, 1}},
                                  {"emissiveTexture", {{"index", texture}}},
                                  {"pbrMetallicRoughness",
                                   {{"baseColorTexture", {{"index", texture}}},
                                    {"metallicRoughnessTexture", {{"index", texture}}}}}};
  const Scene scene = load(glb);
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.base_color_texture, material.emissive_texture) << "the same use, decoded once";
  ASSERT_EQ(scene.textures.size(), 2U);
  const auto red = [&](int index) {
    return scene.textures.at(static_cast<std::size_t>(index)).sample({0, 0}).r;
  };
  EXPECT_NEAR(red(material.base_color_texture), 0.502886F, 1e-5F);
  EXPECT_NEAR(red(material.metallic_roughness_texture), 188.0F / 255.0F, 1e-6F);
}

TEST_F(GltfMaterials, UnusedImagesAreNotDecoded) {
  GlbBuilder glb = with_material(plain);
  glb.add_texture("this is no image");
  EXPECT_TRUE(load(glb).textures.empty());
}

TEST_F(GltfMaterials, SamplersSayHowToWrap) {
  constexpr int clamp = 33071;
  constexpr int mirror = 33648;
  GlbBuilder glb = with_material(plain);
  const int texture = glb.add_texture(png(2, 2, 1, std::vector<std::uint8_t>{0, 255, 0, 255}));
  glb.document["textures"][texture]["sampler"] =
      glb.add("samplers", {{"wrapS", clamp}, {"wrapT", mirror}});
  const int repeated = glb.add("textures", {{"source", 0}});
  glb.document["materials"][0] = textured(texture);
  glb.add("materials", textured(repeated));
  const Scene scene = load(glb);
  ASSERT_EQ(scene.textures.size(), 2U);
  EXPECT_EQ(scene.textures[0].sample({1.25F, 0.25F}).r, 1.0F);
  EXPECT_EQ(scene.textures[1].sample({1.25F, 0.25F}).r, 0.0F);
}

TEST_F(GltfMaterials, TextureCoordinatesAreThoseThatTheBaseColourNames) {
  GlbBuilder glb = with_material(plain);
  const int texture = glb.add_texture(one_pixel(1, 2, 3));
  glb.document["materials"][0] = textured(texture, 1);
  EXPECT_THAT(load(glb).meshes.at(0).uvs, ElementsAre(Vec2(5, 5), Vec2(6, 5), Vec2(5, 6)));
  glb.document["materials"][0] = textured(texture, 0);
  EXPECT_THAT(load(glb).meshes.at(0).uvs, ElementsAre(Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)));
}

TEST_F(GltfMaterials, WarnsOfTexturesThatDisagreeOnTheirCoordinates) {
  GlbBuilder glb = with_material(plain);
  const int texture = glb.add_texture(one_pixel(1, 2, 3));
  glb.document["materials"][0] = textured(texture, 1);
  glb.document["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {
      {"index", texture}};
  const Scene scene = load(glb);
  EXPECT_EQ(scene.meshes.at(0).uvs.at(0), Vec2(5, 5));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("texture coordinates of the first")));
}

TEST_F(GltfMaterials, UntexturedSurfacesKeepNoCoordinates) {
  EXPECT_THAT(load(with_material(plain)).meshes.at(0).uvs, IsEmpty());
}

TEST_F(GltfMaterials, WarnsOfMissingCoordinates) {
  GlbBuilder glb = one_triangle();
  glb.document["meshes"][0]["primitives"][0]["material"] =
      glb.add("materials", textured(glb.add_texture(one_pixel(1, 2, 3))));
  const Scene scene = load(glb);
  EXPECT_THAT(scene.meshes.at(0).uvs, IsEmpty());
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("texture coordinates are missing")));
}

TEST_F(GltfMaterials, EachThingIgnoredIsOneWarning) {
  GlbBuilder glb = with_material(plain);
  const int texture = glb.add_texture(one_pixel(1, 2, 3));
  for (int i = 0; i < 3; ++i) {
    glb.add("materials", {{"normalTexture", {{"index", texture}}}});
  }
  glb.document["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_materials_transmission",
                                    "KHR_materials_emissive_strength"};
  EXPECT_THAT(load(glb).warnings, ElementsAre("the extension KHR_materials_clearcoat is ignored",
                                              "the extension KHR_materials_transmission is ignored",
                                              "normal textures are ignored (3 times, first at "
                                              "materials[1].normalTexture)"));
}

TEST_F(GltfMaterials, ReadsImagesByUri) {
  write("red.png", one_pixel(255, 0, 0));
  GlbBuilder glb = with_material(plain);
  glb.add("images", {{"uri", "red.png"}});
  glb.add("textures", {{"source", 0}});
  glb.document["materials"][0] = textured(0);
  EXPECT_EQ(load(glb).textures.at(0).sample({0, 0}), Vec4(1, 0, 0, 1));
}

TEST_F(GltfMaterials, RefusesATextureWithoutAnImage) {
  GlbBuilder glb = with_material(plain);
  glb.document["materials"][0] = textured(glb.add("textures", Json::object()));
  EXPECT_THAT(error_of(glb), HasSubstr("textures[0]: has no source image"));
}

TEST_F(GltfMaterials, RefusesADamagedImage) {
  GlbBuilder glb = with_material(plain);
  glb.add_texture(one_pixel(1, 2, 3));
  glb.document["materials"][0] = textured(glb.add_texture("this is no image"));
  EXPECT_THAT(error_of(glb), HasSubstr("images[1]: is neither a PNG nor a JPEG image"));
}

/// Files that ask for 16384 x 16384 pixels three times.
TEST_F(GltfMaterials, RefusesMoreTexelsThanMemoryHolds) {
  std::string large = one_pixel(1, 2, 3);
  large.replace(16, 8, std::string("\0\0\x40\0\0\0\x40\0", 8));
  large.replace(29, 4, "\x26\xAA\x87\xD3");
  large.append(50000, '\0');
  GlbBuilder glb = with_material(plain);
  for (int i = 0; i < 3; ++i) {
    glb.add("materials", textured(glb.add_texture(large)));
  }
  EXPECT_THAT(error_of(glb), HasSubstr("images: have 805306368 pixels together"));
}

}  // namespace
}  // namespace foveola::test
