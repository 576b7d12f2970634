#include "renderer/scene/obj/mtl_materials.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>

#include "renderer/base/files/files.h"
#include "renderer/scene/load_scene.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

class MtlMaterials : public InTemporaryFolder {
 protected:
  /// Of a triangle with this material.
  Scene scene_of(const std::string& statements) const {
    write("m.mtl", "newmtl m\n" + statements);
    return load_obj(write("scene.obj",
                          "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\n"
                          "vt 0 1\nusemtl m\nf 1/1 2/2 3/3\n"));
  }
  std::pair<Material, std::vector<std::string>> read(const std::string& statements) const {
    const Scene scene = scene_of(statements);
    return {scene.materials.at(0), scene.warnings};
  }
  Material material(const std::string& statements) const {
    const auto [material, warnings] = read(statements);
    EXPECT_THAT(warnings, IsEmpty()) << statements;
    EXPECT_TRUE(material.double_sided);
    return material;
  }
  std::string grey(const std::string& name, std::uint8_t value) const {
    write(name, png(1, 1, 1, std::vector<std::uint8_t>{value}));
    return name;
  }
};

void expect_lambertian(const Material& material, const Rgb& color) {
  EXPECT_EQ(material.base_color, color);
  EXPECT_EQ(material.specular, 0.0F);
  EXPECT_EQ(material.metallic, 0.0F);
  EXPECT_EQ(material.transmission, 0.0F);
  EXPECT_EQ(material.clearcoat, 0.0F);
  EXPECT_EQ(material.sheen_color, Rgb(0.0F));
  EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
  EXPECT_FALSE(material.is_emissive());
}

TEST_F(MtlMaterials, KdAloneIsLambertian) {
  const Rgb color(0.8F, 0.5F, 0.25F);
  expect_lambertian(material("Kd 0.8 0.5 0.25\n"), color);
  expect_lambertian(material("Ka 1 1 1\nKd 0.8 0.5 0.25\nKs 0 0 0\nNs 500\nillum 2\nd 1\nNi 1.5\n"),
                    color);
  expect_lambertian(material("Kd 0.8 0.5 0.25\nKs 1 1 1\nNs 500\nillum 1\n"), color);
  expect_lambertian(material("Kd 0.8 0.5 0.25\nKs 1 1 1\nNs 500\nillum 0\n"), color);
}

/// Ns = 2 / alpha^2 - 2, and alpha is the square of roughness.
TEST_F(MtlMaterials, KsAndNsAreAHighlight) {
  for (const std::string illum : {"illum 2\n", ""}) {
    const Material m = material("Kd 0.5 0.5 0.5\nKs 0.2 0.4 0.1\nNs 198\nNi 1.45\n" + illum);
    EXPECT_EQ(m.base_color, Rgb(0.5F));
    EXPECT_FLOAT_EQ(m.specular, 0.4F);
    EXPECT_NEAR(m.specular_color.r, 0.5F, 1e-6F);
    EXPECT_NEAR(m.specular_color.g, 1.0F, 1e-6F);
    EXPECT_NEAR(m.specular_color.b, 0.25F, 1e-6F);
    EXPECT_NEAR(std::pow(m.roughness, 2.0F), 0.1F, 1e-6F);
    EXPECT_FLOAT_EQ(m.ior, 1.45F);
  }
  EXPECT_EQ(material("Kd 1 1 1\nKs 1 1 1\nillum 2\nNi 1\n").ior, 1.5F) << "1 means nothing";
}

TEST_F(MtlMaterials, BlackWithAMirrorsIllumIsASmoothMetal) {
  for (const std::string illum : {"illum 3\n", "illum 5\n"}) {
    const Material m = material("Kd 0 0 0\nKs 0.9 0.6 0.3\nNs 10\n" + illum);
    EXPECT_EQ(m.base_color, Rgb(0.9F, 0.6F, 0.3F));
    EXPECT_EQ(m.metallic, 1.0F);
    EXPECT_EQ(m.roughness, 0.0F);
    EXPECT_EQ(m.transmission, 0.0F);
  }
  EXPECT_EQ(material("Kd 0.5 0.5 0.5\nKs 0.9 0.6 0.3\nillum 3\n").metallic, 0.0F);
}

TEST_F(MtlMaterials, GlassIsSolidAndSmooth) {
  for (const std::string statements :
       {"illum 6\nNi 1.33\n", "illum 7\nNi 1.33\nKd 0.3 0.3 0.3\n", "illum 9\nNi 1.33\nd 0.1\n",
        "illum 4\nNi 1.33\nd 0.1\nTf 1 1 1\n", "illum 4\nNi 1.33\nTr 0.9\nKs 0.2 0.2 0.2\n"}) {
    const Material m = material(statements);
    EXPECT_FLOAT_EQ(m.ior, 1.33F) << statements;
    EXPECT_EQ(m.transmission, 1.0F);
    EXPECT_TRUE(m.is_solid);
    EXPECT_EQ(m.roughness, 0.0F);
    EXPECT_EQ(m.specular, 1.0F);
    EXPECT_EQ(m.base_color, Rgb(1.0F));
    EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
  }
  for (const std::string illum : {"illum 4\n", "illum 7\n"}) {
    const Material m = material(illum + "Ni 1.5\nTf 0.9 0.8 0.7\n");
    EXPECT_EQ(m.transmission, 1.0F) << illum;
    EXPECT_EQ(m.base_color, Rgb(0.9F, 0.8F, 0.7F));
  }
}

/// As Maya writes each of its materials, and other exporters do.
TEST_F(MtlMaterials, Illum4AloneIsNoGlass) {
  for (const std::string statements :
       {"illum 4\nKd 0.8 0.2 0.2\nKa 0 0 0\nTf 1 1 1\nNi 1.00\n",
        "illum 4\nKd 0.8 0.2 0.2\nNi 1.5\n", "illum 4\nKd 0.8 0.2 0.2\nTf 1 1 1\nNi 1.5\nd 1\n",
        "illum 4\nKd 0.8 0.2 0.2\nTf 0.5 0.5 0.5\nNi 1\n"}) {
    expect_lambertian(material(statements), Rgb(0.8F, 0.2F, 0.2F));
  }
}

/// Exporters write an Ni wherever they write a d, also for surfaces that enclose nothing.
TEST_F(MtlMaterials, DissolveBlends) {
  for (const std::string statements :
       {"Kd 1 1 1\nd 0.25\n", "Kd 1 1 1\nTr 0.75\nNi 1\n", "Kd 1 1 1\nillum 4\nd 0.25\nNi 1\n",
        "Ns 250\nKa 1 1 1\nKs 0.5 0.5 0.5\nKe 0 0 0\nNi 1.45\nd 0.25\nillum 2\n"}) {
    const Material m = material(statements);
    EXPECT_EQ(m.alpha_mode, AlphaMode::blend) << statements;
    EXPECT_FLOAT_EQ(m.alpha, 0.25F);
    EXPECT_EQ(m.transmission, 0.0F);
  }
}

TEST_F(MtlMaterials, KeShines) {
  const Material lamp = material("Ke 17 12 4\n");
  EXPECT_EQ(lamp.emission, Rgb(17, 12, 4));
  EXPECT_EQ(lamp.base_color, Rgb(0.0F));
  const Material screen = material("map_Ke " + grey("screen.png", 255) + "\n");
  EXPECT_EQ(screen.emission, Rgb(1.0F));
  EXPECT_TRUE(screen.emissive_texture.exists());
}

TEST_F(MtlMaterials, MapDIsACutOut) {
  write("leaf.png", png(2, 1, 3, std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0}));
  write("mask.png", png(2, 1, 1, std::vector<std::uint8_t>{0, 255}));
  const Scene scene = scene_of("map_Kd leaf.png\nmap_d mask.png\nNi 1.5\n");
  const Material& leaf = scene.materials.at(0);
  EXPECT_EQ(leaf.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(leaf.alpha_cutoff, 0.5F);
  EXPECT_EQ(leaf.transmission, 0.0F);
  ASSERT_EQ(scene.textures.size(), 1U);
  EXPECT_EQ(scene.textures[0].sample({0.25F, 0.5F}), Vec4(1, 0, 0, 0));
  EXPECT_EQ(scene.textures[0].sample({0.75F, 0.5F}), Vec4(0, 1, 0, 1));
  EXPECT_EQ(scene_of("Kd 1 1 1\nmap_d mask.png\n").textures.at(0).sample({0.25F, 0.5F}),
            Vec4(1, 1, 1, 0));
}

TEST_F(MtlMaterials, ReadsTheExtensionForPhysicallyBasedRendering) {
  const Material m =
      material("Kd 0.5 0.6 0.7\nPr 0.25\nPm 0.75\nPs 0.5\nPc 0.8\nPcr 0.1\nKs 0 0 0\n");
  EXPECT_EQ(m.base_color, Rgb(0.5F, 0.6F, 0.7F));
  EXPECT_EQ(m.roughness, 0.25F);
  EXPECT_EQ(m.metallic, 0.75F);
  EXPECT_EQ(m.sheen_color, Rgb(0.5F));
  EXPECT_FLOAT_EQ(m.clearcoat, 0.8F);
  EXPECT_FLOAT_EQ(m.clearcoat_roughness, 0.1F);
  EXPECT_EQ(m.specular, 1.0F);
  EXPECT_EQ(material("Kd 1 1 1\nPr 0\n").roughness, 0.0F) << "stated, unlike left out";
}

TEST_F(MtlMaterials, MapsOfRoughnessAndMetalnessShareATexture) {
  const Scene scene = scene_of("Kd 1 1 1\nmap_Pr " + grey("rough.png", 51) + "\nmap_Pm " +
                               grey("metal.png", 204) + "\n");
  const Material& m = scene.materials.at(0);
  EXPECT_EQ(m.roughness, 1.0F);
  EXPECT_EQ(m.metallic, 1.0F);
  ASSERT_EQ(scene.textures.size(), 1U);
  const Vec4 value = scene.textures[0].sample({0.5F, 0.5F});
  EXPECT_FLOAT_EQ(value.g, 0.2F);
  EXPECT_FLOAT_EQ(value.b, 0.8F);
}

TEST_F(MtlMaterials, ClampedOrNotAMapIsDecodedOnce) {
  grey("grey.png", 188);
  const Scene scene = scene_of("map_Kd grey.png\nKs 1 1 1\nmap_Ks -clamp on grey.png\n");
  ASSERT_EQ(scene.textures.size(), 2U);
  EXPECT_EQ(&scene.textures[0].texels(), &scene.textures[1].texels());
}

/// Blender writes normal maps so.
TEST_F(MtlMaterials, ABumpMapInColoursIsANormalMap) {
  write("n.png", one_pixel(218, 128, 218));
  const Scene bump = scene_of("Kd 1 1 1\nmap_Bump -bm 0.5 n.png\n");
  const Scene norm = scene_of("Kd 1 1 1\nnorm -bm 0.5 n.png\n");
  for (const Scene* scene : {&bump, &norm}) {
    EXPECT_THAT(scene->warnings, IsEmpty());
    EXPECT_EQ(scene->materials.at(0).normal_scale, 0.5F);
    EXPECT_NEAR(scene->textures.at(0).sample({0, 0}).r, 218.0F / 255.0F, 1e-6F);
  }
}

/// One picture with associated alpha, and of linear floats: (200, 100, 50) above, in sRGB.
TEST_F(MtlMaterials, TiffsHaveTheirColoursWhateverTheirNumbersAre) {
  for (const char* name : {"associated.tif", "float.tif"}) {
    write(name, read_file(std::filesystem::path(TEST_DATA_DIR) / "pictures" / name));
    const Vec4 above =
        scene_of(std::string("map_Kd ") + name + "\n").textures.at(0).sample({0.5F, 0.25F});
    EXPECT_NEAR(above.r, 0.578, 0.007) << name;  // IEC 61966-2-1 of 200 / 255; within a code
    EXPECT_NEAR(above.g, 0.127, 0.004) << name;
    EXPECT_NEAR(above.b, 0.032, 0.004) << name;
  }
}

TEST_F(MtlMaterials, AMapOverBlackIsSeen) {
  grey("grey.png", 200);
  EXPECT_EQ(material("Kd 0 0 0\nmap_Kd grey.png\nillum 4\nNi 1\nTf 1 1 1\n").base_color, Rgb(1.0F));
  EXPECT_EQ(material("Kd 0 0 0\n").base_color, Rgb(0.0F));
}

/// Blender writes the values of sockets that have textures: 0 of metal and emission.
TEST_F(MtlMaterials, AMapOfAZeroCounts) {
  grey("grey.png", 200);
  EXPECT_EQ(material("Ke 0 0 0\nmap_Ke grey.png\n").emission, Rgb(1.0F));
  EXPECT_EQ(read("Ke 0 0 0\nmap_Ke none.png\n").first.emission, Rgb(0.0F));
  EXPECT_EQ(material("Ke 0.5 0.5 0.5\nmap_Ke grey.png\n").emission, Rgb(0.5F));
  EXPECT_EQ(material("Pr 0.5\nPm 0\nmap_Pm grey.png\n").metallic, 1.0F);
  EXPECT_EQ(material("Pr 0\nPm 0.5\nmap_Pr grey.png\n").roughness, 1.0F);
  EXPECT_EQ(material("Pr 0.5\nPm 0\nmap_Pr grey.png\n").metallic, 0.0F);
}

TEST_F(MtlMaterials, APathMayStandInQuotes) {
  grey("grey.png", 200);
  EXPECT_TRUE(material("map_Kd \"C:\\my pictures\\grey.png\"\n").base_color_texture.exists());
}

TEST_F(MtlMaterials, ColoursAreSrgbAndDataLinear) {
  grey("grey.png", 188);
  EXPECT_NEAR(scene_of("map_Kd grey.png\n").textures.at(0).sample({0, 0}).r, 0.502886F, 1e-5F);
  EXPECT_NEAR(scene_of("map_Kd -colorspace linear grey.png\n").textures.at(0).sample({0, 0}).r,
              188.0F / 255.0F, 1e-6F);
  EXPECT_NEAR(scene_of("Kd 1 1 1\nnorm grey.png\n").textures.at(0).sample({0, 0}).r,
              188.0F / 255.0F, 1e-6F);
}

/// Of the numbers after -o, -s and -t only the first must be there (MTL specification, "Options for
/// texture map statements").
TEST_F(MtlMaterials, TextureOptionsMayLeaveOutNumbers) {
  grey("3d map.png", 255);
  for (const auto& [options, scale, offset] : std::vector<std::tuple<std::string, Vec2, Vec2>>{
           {"", {1, 1}, {0, 0}},
           {"-s 2 4 1 ", {2, 4}, {0, 0}},
           {"-s 2 4 ", {2, 4}, {0, 0}},
           {"-s 2 ", {2, 1}, {0, 0}},
           {"-o 0.5 0.25 ", {1, 1}, {0.5F, 0.25F}},
           {"-o .5\t", {1, 1}, {0.5F, 0}},
           {"-t 1 -s 2 4 -clamp off  -mm 0 1 -o 0.5 -bm 2 ", {2, 4}, {0.5F, 0}}}) {
    const Scene scene = scene_of("map_Kd " + options + "3d map.png\n");
    EXPECT_THAT(scene.warnings, IsEmpty()) << options;
    const TextureUse& use = scene.materials.at(0).base_color_texture;
    ASSERT_TRUE(use.exists()) << options;
    EXPECT_EQ(use.texture_from_mesh,
              Mat3x2(scale.x, 0, 0, scale.y, offset.x, 1.0F - scale.y - offset.y))
        << options;
  }
}

TEST_F(MtlMaterials, MapsWithoutAFileAreNoMaps) {
  for (const std::string map :
       {"map_Kd", "map_d -s 2 2", "norm -bm 2", "map_Pr -o 1 1 1", "bump"}) {
    const auto [material, warnings] = read("Kd 0.8 0.5 0.25\n" + map + "\n");
    expect_lambertian(material, Rgb(0.8F, 0.5F, 0.25F));
    EXPECT_THAT(warnings, ElementsAre("a map that names no file is ignored (m.mtl: m)")) << map;
  }
}

TEST_F(MtlMaterials, WhatIsNoNumberIsNotZero) {
  for (const std::string statement :
       {"Kd nan 0.5 0.5", "Kd spectral red.rfl", "Kd 0,5 0,5 0,5", "Kd"}) {
    const auto [material, warnings] = read("Kd 0.8 0.5 0.25\n" + statement + "\n");
    expect_lambertian(material, Rgb(0.8F, 0.5F, 0.25F));
    EXPECT_THAT(warnings, ElementsAre("Kd is ignored, for it has no numbers (m.mtl: m)"))
        << statement;
  }
  EXPECT_THAT(read("Ke inf inf inf\nNs 1.#QNAN\nd half\n").second,
              ElementsAre("Ke is ignored, for it has no numbers (m.mtl: m)",
                          "Ns is ignored, for it has no numbers (m.mtl: m)",
                          "d is ignored, for it has no numbers (m.mtl: m)"));
}

TEST_F(MtlMaterials, OneNumberIsAGrey) {
  expect_lambertian(material("Kd 0.5\n"), Rgb(0.5F));
  expect_lambertian(material("Kd 0.5 # of all\n"), Rgb(0.5F));
}

TEST_F(MtlMaterials, HaloIsReadWithoutItsHalo) {
  const auto [material, warnings] = read("Kd 1 1 1\nd -halo 0.25\n");
  EXPECT_EQ(material.alpha_mode, AlphaMode::blend);
  EXPECT_FLOAT_EQ(material.alpha, 0.25F);
  EXPECT_THAT(warnings, ElementsAre("-halo is ignored (m.mtl: m)"));
}

TEST_F(MtlMaterials, SaysWhatItIgnoresAndLimits) {
  grey("bump.png", 9);
  EXPECT_THAT(read("Kd 2 0.5 -1\nmap_Bump bump.png\nmap_Ns bump.png\n").second,
              ElementsAre("Kd is clamped to its range (2 times, first at m.mtl: m)",
                          "bump maps in greys are ignored (m.mtl: m)",
                          "maps of the highlight's exponent are ignored (m.mtl: m)"));
  EXPECT_EQ(read("Kd 2 0.5 -1\n").first.base_color, Rgb(1, 0.5F, 0));
}

}  // namespace
}  // namespace foveola::test
