
#include "tests/encoded_image.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

const Json no_values = Json::object();

using GltfTextures = LoadGltf;

/// Each value without its texture, which a warning names once; the others keep theirs.
TEST_F(GltfTextures, TexturesThatCannotBeHadAreLeftOut) {
  write("text.png", "this is no image");
  GlbBuilder glb = with_material(no_values);
  glb.add("images", {{"uri", "gone.png"}});
  glb.add("images", {{"uri", "text.png"}});
  glb.add("textures", {{"source", 0}});
  glb.add("textures", {{"source", 1}});
  const int good = glb.add_texture(one_pixel(255, 0, 0));
  Json material = {{"emissiveFactor", {0.5, 0.5, 0.5}},
                   {"normalTexture", {{"index", 0}}},
                   {"emissiveTexture", {{"index", good}}}};
  material["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 1}}},
                                      {"metallicRoughnessTexture", {{"index", 1}}}};
  glb.document["materials"][0] = material;
  const Scene scene = load(glb);
  const Material& shown = scene.materials.at(0);
  EXPECT_FALSE(shown.normal_texture.exists());
  EXPECT_FALSE(shown.base_color_texture.exists());
  EXPECT_FALSE(shown.metallic_roughness_texture.exists());
  ASSERT_EQ(scene.textures.size(), 1U);
  EXPECT_EQ(shown.emissive_texture.texture, 0);
  EXPECT_EQ(scene.textures[0].sample({0, 0}), Vec4(1, 0, 0, 1));
  EXPECT_THAT(
      scene.warnings,
      ElementsAre("a texture is left out: images[0].uri refers to \"gone.png\", a file that does "
                  "not exist",
                  "a texture is left out: images[1] (text.png) is not a PNG, JPEG or WebP image"));
  EXPECT_TRUE(scene.files.contains(folder() / "gone.png")) << "it may come yet";
}

TEST_F(GltfTextures, ReadsWebPTextures) {
  GlbBuilder glb = with_material(no_values);
  const int webp =
      glb.add_texture(encoded_image({"webp", 1, 1, 3, std::vector<std::uint8_t>{255, 255, 255}}));
  glb.document["textures"][webp] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
  glb.document["extensionsUsed"] = {"EXT_texture_webp"};
  glb.document["extensionsRequired"] = {"EXT_texture_webp"};
  glb.document["materials"][0] = textured(webp);
  const Scene scene = load(glb);
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_NEAR(scene.textures.at(0).sample({0, 0}).g, 1.0F, 0.01F);
}

TEST_F(GltfTextures, InPlaceOfKtx2ImagesTheFallbackIsShown) {
  GlbBuilder glb = with_material(no_values);
  glb.document["extensionsUsed"] = {"KHR_texture_basisu"};
  const int texture = glb.add_texture(one_pixel(255, 0, 0));
  glb.add_texture("\xABKTX 20\xBB\r\n\x1A\n");
  glb.document["textures"][texture]["extensions"] = {{"KHR_texture_basisu", {{"source", 1}}}};
  glb.document["materials"][0] = textured(texture);
  const std::string ignored =
      "the extension KHR_texture_basisu is ignored: KTX2 images are not read, export them as PNG "
      "or "
      "JPEG";
  const Scene with_fallback = load(glb);
  EXPECT_EQ(with_fallback.textures.at(0).sample({0, 0}), Vec4(1, 0, 0, 1));
  EXPECT_THAT(with_fallback.warnings, ElementsAre(ignored));

  glb.document["textures"][texture].erase("source");
  const Scene without = load(glb);
  EXPECT_TRUE(without.textures.empty());
  EXPECT_THAT(without.warnings,
              ElementsAre(ignored,
                          "a texture is left out: textures[0] has its image in KTX2 alone "
                          "(KHR_texture_basisu), which is not read: export it as PNG or "
                          "JPEG"));
  glb.document["textures"][texture]["source"] = 1;
  EXPECT_THAT(load(glb).warnings,
              ElementsAre(ignored, HasSubstr("images[1] is a KTX2 image, which is not read")));
}

}  // namespace
}  // namespace foveola::test
