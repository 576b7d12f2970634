#include <cmath>
#include <limits>

#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

class MaterialExtensions : public LoadGltf {
 protected:
  /// A textured triangle whose material has `extensions`; textures 0 to 3 exist.
  Scene scene_with(const Json& extensions, Json material = Json::object()) const {
    GlbBuilder glb = one_triangle();
    Json& primitive = glb.primitive();
    primitive["attributes"]["TEXCOORD_0"] = glb.add_uvs({{0, 0}, {1, 0}, {0, 1}});
    material["extensions"] = extensions;
    primitive["material"] = glb.add("materials", material);
    for (std::uint8_t grey = 0; grey < 4; ++grey) {
      glb.add_texture(png(1, 1, 1, std::vector<std::uint8_t>{grey}));
    }
    return load(glb);
  }
  Material read(const Json& extensions) const { return scene_with(extensions).materials.at(0); }
};

const Json texture_0 = {{"index", 0}};
const Json texture_1 = {{"index", 1}};

/// The defaults of the extensions' tables.
TEST_F(MaterialExtensions, WithoutThemThereIsNoneOfTheirEffects) {
  const Scene scene = scene_with(Json::object());
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.ior, 1.5F);
  EXPECT_EQ(material.specular, 1.0F);
  EXPECT_EQ(material.specular_color, Rgb(1.0F));
  EXPECT_EQ(material.transmission, 0.0F);
  EXPECT_FALSE(material.is_solid);
  EXPECT_EQ(material.clearcoat, 0.0F);
  EXPECT_EQ(material.sheen_color, Rgb(0.0F));
  EXPECT_FALSE(material.unlit);
  EXPECT_THAT(scene.textures, IsEmpty());
}

/// KHR_materials_pbrSpecularGlossiness: F0 is the specular colour, which of a dielectric of
/// index 1.5 is 0.04 times specular_color; the roughness is 1 - glossiness.
TEST_F(MaterialExtensions, SpecularGlossiness) {
  const Json values = {{"diffuseFactor", {0.25, 0.5, 0.75, 0.5}},
                       {"specularFactor", {0.5, 0.25, 0.04}},
                       {"glossinessFactor", 0.75}};
  const Json fallback = {{"alphaMode", "BLEND"},
                         {"pbrMetallicRoughness", {{"metallicFactor", 1.0}}}};
  const Scene scene = scene_with({{"KHR_materials_pbrSpecularGlossiness", values}}, fallback);
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.base_color, Rgb(0.25F, 0.5F, 0.75F));
  EXPECT_EQ(material.alpha, 0.5F);
  EXPECT_EQ(material.alpha_mode, AlphaMode::blend);
  EXPECT_EQ(material.metallic, 0.0F);
  EXPECT_EQ(material.roughness, 0.25F);
  EXPECT_NEAR(0.04F * material.specular_color.r, 0.5F, 1e-6F);
  EXPECT_NEAR(0.04F * material.specular_color.b, 0.04F, 1e-6F);
  EXPECT_THAT(scene.warnings, IsEmpty());
  const Material absent = read({{"KHR_materials_pbrSpecularGlossiness", Json::object()}});
  EXPECT_EQ(absent.base_color, Rgb(1.0F));
  EXPECT_EQ(absent.roughness, 0.0F);
  EXPECT_NEAR(absent.specular_color.g, 25.0F, 1e-5F);
}

/// An alpha of 51 is a glossiness of 0.2; times 0.5, a roughness of 0.9, in green.
TEST_F(MaterialExtensions, SpecularGlossinessTextures) {
  GlbBuilder glb = with_material(Json::object());
  const int texture = glb.add_texture(png(1, 1, 4, std::vector<std::uint8_t>{255, 0, 0, 51}));
  const Json values = {{"diffuseTexture", {{"index", texture}}},
                       {"specularGlossinessTexture", {{"index", texture}}},
                       {"glossinessFactor", 0.5}};
  glb.document["materials"][0]["extensions"] = {{"KHR_materials_pbrSpecularGlossiness", values}};
  const Scene scene = load(glb);
  const Material& material = scene.materials.at(0);
  const auto value = [&](const TextureUse& use) {
    return scene.textures.at(static_cast<std::size_t>(use.texture)).sample({0, 0});
  };
  EXPECT_EQ(value(material.base_color_texture), Vec4(1, 0, 0, 0.2F));
  EXPECT_EQ(value(material.specular_color_texture), Vec4(1, 0, 0, 0.2F));
  EXPECT_EQ(material.roughness, 1.0F);
  EXPECT_NEAR(value(material.metallic_roughness_texture).g, 0.9F, 0.51F / 255.0F);
}

TEST_F(MaterialExtensions, Ior) {
  EXPECT_EQ(read({{"KHR_materials_ior", {{"ior", 1.33}}}}).ior, 1.33F);
  const Scene below = scene_with({{"KHR_materials_ior", {{"ior", 0.5}}}});
  EXPECT_EQ(below.materials.at(0).ior, 1.0F);
  EXPECT_THAT(
      below.warnings,
      ElementsAre("ior is clamped to its range (materials[0].extensions.KHR_materials_ior.ior)"));
}

/// The extension: at 0 the Fresnel term is 1. At normal incidence it is ((n - 1) / (n + 1))^2.
TEST_F(MaterialExtensions, AnIorOfZeroReflectsEverything) {
  const Scene scene = scene_with({{"KHR_materials_ior", {{"ior", 0}}}});
  const double ior = scene.materials.at(0).ior;
  EXPECT_NEAR(std::pow((ior - 1.0) / (ior + 1.0), 2.0), 1.0, 1e-5);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(MaterialExtensions, Transmission) {
  const Material glass =
      read({{"KHR_materials_transmission",
             {{"transmissionFactor", 0.75}, {"transmissionTexture", texture_0}}}});
  EXPECT_EQ(glass.transmission, 0.75F);
  EXPECT_EQ(glass.transmission_texture.texture, 0);
  EXPECT_FALSE(glass.is_solid) << "thin-walled without a volume";
}

TEST_F(MaterialExtensions, AThicknessMakesAVolume) {
  const Material glass = read({{"KHR_materials_volume",
                                {{"thicknessFactor", 0.001},
                                 {"attenuationDistance", 0.25},
                                 {"attenuationColor", {0.5, 0.25, 1}}}}});
  EXPECT_TRUE(glass.is_solid);
  EXPECT_EQ(glass.attenuation_distance_m, 0.25F);
  EXPECT_EQ(glass.attenuation_color, Rgb(0.5F, 0.25F, 1.0F));
  EXPECT_FALSE(read({{"KHR_materials_volume", {{"attenuationDistance", 0.25}}}}).is_solid)
      << "the default thickness is 0";
}

TEST_F(MaterialExtensions, AttenuationDistanceIsInfiniteUnlessPositive) {
  const auto distance = [&](const Json& value) {
    return read(
               {{"KHR_materials_volume", {{"thicknessFactor", 1}, {"attenuationDistance", value}}}})
        .attenuation_distance_m;
  };
  EXPECT_TRUE(std::isinf(distance(0)));
  EXPECT_TRUE(std::isinf(distance(-3.5)));
  EXPECT_TRUE(std::isinf(distance(1.7976931348623157e308))) << "some write no other infinity";
  EXPECT_GT(distance(1e-300), 0.0F);
}

TEST_F(MaterialExtensions, Specular) {
  const Material material = read({{"KHR_materials_specular",
                                   {{"specularFactor", 0.5},
                                    {"specularTexture", texture_0},
                                    {"specularColorFactor", {2, 0.5, 0}},
                                    {"specularColorTexture", texture_0}}}});
  EXPECT_EQ(material.specular, 0.5F);
  EXPECT_EQ(material.specular_color, Rgb(2.0F, 0.5F, 0.0F)) << "has no upper limit";
  EXPECT_EQ(material.specular_texture.texture, 0);
  EXPECT_EQ(material.specular_color_texture.texture, 0) << "the same image, decoded once";
}

TEST_F(MaterialExtensions, Clearcoat) {
  const Material material = read({{"KHR_materials_clearcoat",
                                   {{"clearcoatFactor", 0.5},
                                    {"clearcoatTexture", texture_0},
                                    {"clearcoatRoughnessFactor", 0.25},
                                    {"clearcoatRoughnessTexture", texture_1},
                                    {"clearcoatNormalTexture", {{"index", 1}, {"scale", -0.5}}}}}});
  EXPECT_EQ(material.clearcoat, 0.5F);
  EXPECT_EQ(material.clearcoat_roughness, 0.25F);
  EXPECT_EQ(material.clearcoat_texture.texture, 0);
  EXPECT_EQ(material.clearcoat_roughness_texture.texture, 1);
  EXPECT_TRUE(material.clearcoat_normal_texture.exists());
  EXPECT_EQ(material.clearcoat_normal_scale, -0.5F);
  EXPECT_FALSE(material.normal_texture.exists());
}

TEST_F(MaterialExtensions, ANormalTextureOfTheClearcoatAloneGetsTangents) {
  const Scene scene =
      scene_with({{"KHR_materials_clearcoat",
                   {{"clearcoatFactor", 1}, {"clearcoatNormalTexture", texture_1}}}});
  EXPECT_EQ(scene.meshes.at(0).tangents.size(), scene.meshes.at(0).positions.size());
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(MaterialExtensions, Sheen) {
  const Material material = read({{"KHR_materials_sheen",
                                   {{"sheenColorFactor", {0.5, 0.25, 0}},
                                    {"sheenColorTexture", texture_0},
                                    {"sheenRoughnessFactor", 0.75},
                                    {"sheenRoughnessTexture", texture_1}}}});
  EXPECT_EQ(material.sheen_color, Rgb(0.5F, 0.25F, 0.0F));
  EXPECT_EQ(material.sheen_roughness, 0.75F);
  EXPECT_EQ(material.sheen_color_texture.texture, 0);
  EXPECT_EQ(material.sheen_roughness_texture.texture, 1);
}

TEST_F(MaterialExtensions, EmissiveStrengthIsLimited) {
  const Scene scene = scene_with({{"KHR_materials_emissive_strength", {{"emissiveStrength", -1}}}},
                                 {{"emissiveFactor", {1, 1, 1}}});
  EXPECT_EQ(scene.materials.at(0).emission, Rgb(0.0F));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("emissiveStrength is clamped to its range")));
}

TEST_F(MaterialExtensions, FactorsAreLimitedWithAWarning) {
  const Scene scene = scene_with({{"KHR_materials_transmission", {{"transmissionFactor", 1.5}}},
                                  {"KHR_materials_clearcoat", {{"clearcoatFactor", -2}}},
                                  {"KHR_materials_sheen", {{"sheenColorFactor", {1, 3, -1}}}},
                                  {"KHR_materials_specular", {{"specularFactor", 7}}}});
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.transmission, 1.0F);
  EXPECT_EQ(material.clearcoat, 0.0F);
  EXPECT_EQ(material.sheen_color, Rgb(1.0F, 1.0F, 0.0F));
  EXPECT_EQ(material.specular, 1.0F);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("transmissionFactor is clamped"),
                                          HasSubstr("specularFactor is clamped"),
                                          HasSubstr("clearcoatFactor is clamped"),
                                          HasSubstr("sheenColorFactor is clamped")));
}

/// What a factor of 0 multiplies need not be loaded.
TEST_F(MaterialExtensions, TexturesWithoutEffectAreNotLoaded) {
  const Json extensions = {
      {"KHR_materials_transmission", {{"transmissionTexture", texture_0}}},
      {"KHR_materials_clearcoat",
       {{"clearcoatTexture", texture_0}, {"clearcoatNormalTexture", texture_0}}},
      {"KHR_materials_sheen",
       {{"sheenColorTexture", texture_0}, {"sheenRoughnessTexture", texture_0}}},
      {"KHR_materials_specular",
       {{"specularFactor", 0},
        {"specularTexture", texture_0},
        {"specularColorTexture", texture_0}}}};
  const Json material = {{"emissiveTexture", texture_0},
                         {"normalTexture", {{"index", 0}, {"scale", 0}}},
                         {"pbrMetallicRoughness",
                          {{"baseColorFactor", {0, 0, 0, 1}},
                           {"baseColorTexture", texture_0},
                           {"metallicFactor", 0},
                           {"roughnessFactor", 0},
                           {"metallicRoughnessTexture", texture_0}}}};
  const Scene scene = scene_with(extensions, material);
  EXPECT_THAT(scene.textures, IsEmpty());
  EXPECT_THAT(scene.meshes.at(0).uv_sets, IsEmpty());
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(MaterialExtensions, OfAnUnlitMaterialOnlyTheBaseColourCounts) {
  const Scene scene = scene_with({{"KHR_materials_unlit", Json::object()},
                                  {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}}},
                                 {{"emissiveFactor", {1, 1, 1}},
                                  {"normalTexture", texture_1},
                                  {"pbrMetallicRoughness",
                                   {{"baseColorFactor", {0.5, 0.25, 1, 1}},
                                    {"baseColorTexture", texture_0},
                                    {"metallicRoughnessTexture", texture_1}}}});
  const Material& material = scene.materials.at(0);
  EXPECT_TRUE(material.unlit);
  EXPECT_EQ(material.base_color, Rgb(0.5F, 0.25F, 1.0F));
  EXPECT_TRUE(material.base_color_texture.exists());
  EXPECT_FALSE(material.is_emissive());
  EXPECT_EQ(material.clearcoat, 0.0F);
  EXPECT_EQ(scene.textures.size(), 1U);
}

TEST_F(MaterialExtensions, NormalScaleIsRead) {
  const Json normal = {{"index", 0}, {"scale", -0.5}};
  const Material material = scene_with(Json::object(), {{"normalTexture", normal}}).materials.at(0);
  EXPECT_EQ(material.normal_scale, -0.5F);
  EXPECT_TRUE(material.normal_texture.exists());
}

}  // namespace
}  // namespace foveola::test
