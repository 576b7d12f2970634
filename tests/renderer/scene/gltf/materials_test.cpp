#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

const Json plain = Json::object();

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
  EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(GltfMaterials, APrimitiveWithoutOneHasTheDefault) {
  GlbBuilder glb = with_material({{"name", "unused"}});
  glb.primitive().erase("material");
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
              ElementsAre("baseColorFactor is clamped to its range "
                          "(materials[0].pbrMetallicRoughness.baseColorFactor)",
                          HasSubstr("metallicFactor is"), HasSubstr("roughnessFactor is")));
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

TEST_F(GltfMaterials, AlphaModesAreReadAsTheyAre) {
  const auto mode = [&](const char* name) { return read({{"alphaMode", name}}).first.alpha_mode; };
  EXPECT_EQ(mode("OPAQUE"), AlphaMode::opaque);
  EXPECT_EQ(mode("MASK"), AlphaMode::mask);
  EXPECT_EQ(mode("BLEND"), AlphaMode::blend);
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
  EXPECT_EQ(material.base_color_texture.texture, material.emissive_texture.texture)
      << "the same use, decoded once";
  ASSERT_EQ(scene.textures.size(), 2U);
  const auto red = [&](const TextureUse& use) {
    return scene.textures.at(static_cast<std::size_t>(use.texture)).sample({0, 0}).r;
  };
  EXPECT_NEAR(red(material.base_color_texture), 0.502886F, 1e-5F);
  EXPECT_NEAR(red(material.metallic_roughness_texture), 188.0F / 255.0F, 1e-6F);
}

TEST_F(GltfMaterials, ImagesOfMaterialsThatNothingHasAreNotDecoded) {
  GlbBuilder glb = with_material(plain);
  glb.add("materials", textured(glb.add_texture("this is no image")));
  glb.add("materials", textured(glb.add_texture("this is no image")));
  Json elsewhere = glb.document["meshes"][0];
  elsewhere["primitives"][0]["material"] = 2;
  glb.add("meshes", elsewhere);  // which no node shows
  const Scene scene = load(glb);
  EXPECT_TRUE(scene.textures.empty());
  EXPECT_FALSE(scene.materials.at(1).base_color_texture.exists());
}

/// Light that is traced finds what is in its way, and how far through a mesh it goes.
TEST_F(GltfMaterials, OcclusionAndThicknessTexturesHaveNoEffect) {
  const Json texture = {{"index", 0}};
  const Json volume = {{"thicknessFactor", 1.0}, {"thicknessTexture", texture}};
  GlbBuilder glb = with_material(
      {{"occlusionTexture", texture}, {"extensions", {{"KHR_materials_volume", volume}}}});
  glb.add_texture(one_pixel(0, 0, 0));
  const Scene scene = load(glb);
  EXPECT_THAT(scene.textures, IsEmpty());
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_TRUE(scene.materials.at(0).is_solid);
}

TEST_F(GltfMaterials, SamplersSayHowToWrap) {
  constexpr int clamp = 33071;
  constexpr int mirror = 33648;
  GlbBuilder glb = with_material(plain);
  const int texture = glb.add_texture(png(2, 2, 1, std::vector<std::uint8_t>{0, 255, 0, 255}));
  const int clamped = glb.add("textures", {{"source", 0}});
  glb.document["textures"][clamped]["sampler"] =
      glb.add("samplers", {{"wrapS", clamp}, {"wrapT", mirror}});
  glb.document["materials"][0] = textured(clamped);
  EXPECT_EQ(load(glb).textures.at(0).sample({1.25F, 0.25F}).r, 1.0F);
  glb.document["materials"][0] = textured(texture);
  EXPECT_EQ(load(glb).textures.at(0).sample({1.25F, 0.25F}).r, 0.0F);
}

/// The first sampler never reads a coarser level, and the third does.
/// Sixteen times a black and a white column of texels.
std::string sixteen_stripes() {
  std::vector<std::uint8_t> codes(32);
  for (std::size_t i = 1; i < codes.size(); i += 2) {
    codes[i] = 255;
  }
  return png(32, 1, 1, codes);
}

TEST_F(GltfMaterials, AnImageUnderThreeSamplersIsDecodedOnce) {
  constexpr int linear = 9729;
  constexpr int clamp = 33071;
  GlbBuilder glb = with_material(plain);
  glb.add_texture(sixteen_stripes());
  glb.document["textures"] = Json::array();
  for (const Json& sampler :
       {Json{{"minFilter", linear}}, Json{{"minFilter", linear}, {"wrapS", clamp}}, plain}) {
    glb.add("textures", {{"source", 0}, {"sampler", glb.add("samplers", sampler)}});
  }
  glb.document["materials"][0] = {
      {"pbrMetallicRoughness",
       {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 0}}}}},
      {"emissiveFactor", {1, 1, 1}},
      {"emissiveTexture", {{"index", 1}}},
      {"extensions",
       {{"KHR_materials_sheen",
         {{"sheenColorFactor", {1, 1, 1}}, {"sheenColorTexture", {{"index", 2}}}}}}}};
  const Scene scene = load(glb);
  ASSERT_EQ(scene.textures.size(), 4U);
  const auto texture = [&](const TextureUse& use) -> const Texture& {
    return scene.textures[static_cast<std::size_t>(use.texture)];
  };
  const Material& m = scene.materials.at(0);
  const Texture& base = texture(m.base_color_texture);
  EXPECT_EQ(&texture(m.emissive_texture).texels(), &base.texels());
  EXPECT_EQ(&texture(m.sheen_color_texture).texels(), &base.texels());
  EXPECT_NE(&texture(m.metallic_roughness_texture).texels(), &base.texels()) << "is linear";
  const Vec2 black(0.25F / 16.0F, 0.5F);
  EXPECT_EQ(base.sample(black, 1.0F).r, 0.0F);
  EXPECT_NEAR(texture(m.sheen_color_texture).sample(black, 1.0F).r, 0.5F, 0.01F);
}

/// The centres of two stripes are at a quarter and three quarters of their width: at 0.4 linear
/// filtering gives (0.4 - 0.25) / 0.5 and the nearest texel is black; in the only coarser level
/// all is their mean, a half.
TEST_F(GltfMaterials, SamplersSayHowToFilter) {
  const auto texture = [&](const Json& sampler) {
    GlbBuilder glb = with_material(plain);
    const int index = glb.add_texture(sixteen_stripes());
    glb.document["textures"][index]["sampler"] = glb.add("samplers", sampler);
    // Of its linear channels, so that the mean of the codes is that of the values.
    glb.document["materials"][0] = {
        {"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", index}}}}}};
    return load(glb).textures.at(0);
  };
  constexpr int nearest = 9728;
  constexpr int linear = 9729;
  constexpr int nearest_mipmap_nearest = 9984;
  constexpr int linear_mipmap_linear = 9987;
  const Vec2 uv(0.4F / 16.0F, 0.5F);
  EXPECT_NEAR(texture(plain).sample(uv).g, 0.3F, 1e-6F);
  EXPECT_NEAR(texture({{"magFilter", linear}}).sample(uv).g, 0.3F, 1e-6F);
  EXPECT_EQ(texture({{"magFilter", nearest}}).sample(uv).g, 0.0F);
  EXPECT_NEAR(texture(plain).sample(uv, 1.0F).g, 0.5F, 0.01F);
  EXPECT_NEAR(texture({{"minFilter", linear_mipmap_linear}}).sample(uv, 1.0F).g, 0.5F, 0.01F);
  EXPECT_NEAR(texture({{"minFilter", nearest_mipmap_nearest}}).sample(uv, 1.0F).g, 0.5F, 0.01F);
  EXPECT_NEAR(texture({{"minFilter", linear}}).sample(uv, 1.0F).g, 0.3F, 1e-6F);
  EXPECT_EQ(texture({{"minFilter", nearest}}).sample(uv, 1.0F).g, 0.0F);
}

TEST_F(GltfMaterials, AMeshKeepsTheCoordinatesThatItsTexturesUse) {
  GlbBuilder glb = with_material(plain);
  const int texture = glb.add_texture(one_pixel(1, 2, 3));
  const auto first = ElementsAre(Vec2(0, 0), Vec2(1, 0), Vec2(0, 1));
  const auto second = ElementsAre(Vec2(5, 5), Vec2(6, 5), Vec2(5, 6));
  glb.document["materials"][0] = textured(texture, 1);
  EXPECT_THAT(load(glb).meshes.at(0).uv_sets, ElementsAre(second));
  EXPECT_EQ(load(glb).materials.at(0).base_color_texture.uv_set, 0);
  glb.document["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {
      {"index", texture}};
  const Scene both = load(glb);
  EXPECT_THAT(both.meshes.at(0).uv_sets, ElementsAre(second, first));
  EXPECT_EQ(both.materials.at(0).base_color_texture.uv_set, 0);
  EXPECT_EQ(both.materials.at(0).metallic_roughness_texture.uv_set, 1);
  EXPECT_THAT(both.warnings, IsEmpty());
}

TEST_F(GltfMaterials, WithoutOneOfItsCoordinatesAMeshShowsNoTexture) {
  GlbBuilder glb = with_material(plain);
  const int texture = glb.add_texture(one_pixel(1, 2, 3));
  glb.document["materials"][0] = textured(texture, 0);
  glb.document["materials"][0]["normalTexture"] = {{"index", texture}, {"texCoord", 2}};
  const Scene scene = load(glb);
  EXPECT_THAT(scene.meshes.at(0).uv_sets, IsEmpty());
  EXPECT_THAT(scene.meshes.at(0).tangents, IsEmpty());
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("texture coordinates are missing")));
}

TEST_F(GltfMaterials, EachThingIgnoredIsOneWarning) {
  GlbBuilder glb = with_material(plain);
  const Json volume = {{"thicknessFactor", 1}, {"attenuationDistance", 0}};
  for (int i = 0; i < 3; ++i) {
    glb.add("materials", {{"extensions", {{"KHR_materials_volume", volume}}}});
  }
  glb.document["extensionsUsed"] = {"KHR_materials_iridescence", "KHR_materials_volume",
                                    "KHR_materials_emissive_strength"};
  EXPECT_THAT(load(glb).warnings,
              ElementsAre("the extension KHR_materials_iridescence is ignored: thin films have no "
                          "colours",
                          "an attenuationDistance that is not positive is taken as infinite (3 "
                          "times, first at materials[1].extensions.KHR_materials_volume."
                          "attenuationDistance)"));
}

TEST_F(GltfMaterials, RefusesATextureWithoutAnImage) {
  GlbBuilder glb = with_material(plain);
  glb.document["materials"][0] = textured(glb.add("textures", Json::object()));
  EXPECT_THAT(strict_error_of(glb), HasSubstr("textures[0]: has no source image"));
}

/// 768 MiB each, in files that a constant colour could be so small in.
TEST_F(GltfMaterials, RefusesMoreTexelsThanItsFilesHaveARightTo) {
  GlbBuilder glb = with_material(plain);
  glb.document["materials"][0] = textured(glb.add_texture(huge_png(100000)));
  EXPECT_THAT(error_of(glb), HasSubstr("images: would take 768 MiB of memory, more than 256 and "
                                       "more than 4096 times the 100"));
  EXPECT_THAT(error_of(glb), HasSubstr(" bytes of the files"));
}

/// Images of 768 MiB each.
TEST_F(GltfMaterials, RefusesMoreTexelsThanHalfOfTheMemoryHolds) {
  const double memory_mib = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
                            static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
  const double limit_mib = std::max(2048.0, memory_mib / 2.0);
  const int images = static_cast<int>(limit_mib / 768.0) + 1;
  GlbBuilder glb = with_material(plain);
  Json primitive = glb.primitive();
  const std::string large = huge_png(50000);
  for (int i = 0; i < images; ++i) {
    primitive["material"] = glb.add("materials", textured(glb.add_texture(large)));
    glb.document["meshes"][0]["primitives"].push_back(primitive);
  }
  EXPECT_THAT(
      error_of(glb),
      HasSubstr(fmt::format("images: would take {} MiB of memory, of which {:.0f} are allowed here",
                            768 * images, limit_mib)));
}

}  // namespace
}  // namespace foveola::test
