// OBJ files as other programs and systems write them, and that lack a texture.
#include <cmath>

#include "tests/encoded_image.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/obj/obj_text.h"

namespace foveola::test {
namespace {

class ForeignObj : public ObjText {};

/// Two squares that meet at a right angle, with the edge of x = 0 in common, where the mean of
/// their normals is +Y.
TEST_F(ForeignObj, SmoothingGroupsHaveSmoothNormals) {
  const std::string roof = "v 0 0 0\nv 0 0 1\nv -1 -1 1\nv -1 -1 0\nv 1 -1 1\nv 1 -1 0\n";
  const std::string left = "f 1 4 3 2\n";
  const std::string right = "f 1 2 5 6\n";
  const Scene smooth = load(roof + "s 1\n" + left + right);
  const Mesh& mesh = smooth.meshes.at(0);
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  int edges = 0;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const float x = mesh.positions[i].x;
    const Vec3 expected = glm::normalize(Vec3(x, 1.0F, 0.0F));
    EXPECT_NEAR(glm::distance(mesh.normals[i], expected), 0.0F, 1e-6F) << x;
    edges += x == 0.0F ? 1 : 0;
  }
  EXPECT_EQ(edges, 2) << "one vertex for both faces";
  EXPECT_TRUE(load(roof + "s off\n" + left + right).meshes.at(0).normals.empty());
  const Mesh two = load(roof + "s 1\n" + left + "s 2\n" + right).meshes.at(0);
  for (std::size_t i = 0; i < two.normals.size(); ++i) {
    EXPECT_NEAR(std::abs(two.normals[i].x), std::sqrt(0.5F), 1e-6F) << "of its own group alone";
  }
}

/// Blender's exporter writes absolute paths by default.
TEST_F(ForeignObj, TexturesOfAnotherMachineAreThoseBesideTheScene) {
  const std::string image = one_pixel(255, 0, 0);
  write("wood.png", image);
  write("sub/stone.png", image);
  for (const char* library : {"m.mtl", "sub/m.mtl"}) {
    for (const char* path : {"/home/artist/wood.png", "C:\\maps\\Wood.png", "file:///x/wood.png"}) {
      write(library, std::string("newmtl m\nmap_Kd ") + path + "\n");
      const Scene scene =
          load("mtllib " + std::string(library) + "\n" + three_corners + textured_face);
      EXPECT_THAT(scene.warnings, IsEmpty()) << library << " " << path;
      ASSERT_EQ(scene.textures.size(), 1U);
    }
  }
  write("sub/m.mtl", "newmtl m\nmap_Kd /x/stone.png\n");
  EXPECT_EQ(load("mtllib sub\\m.mtl\n" + three_corners + textured_face).textures.size(), 1U);
  write("m.mtl", "newmtl m\nmap_Kd /x/gone.png\n");
  const std::string gone = "mtllib C:\\x\\m.mtl\n" + three_corners + textured_face;
  EXPECT_THAT(load(gone).warnings,
              ElementsAre("a texture is left out: gone.png does not exist (m.mtl: m)"));
  EXPECT_THAT(strict_error_of(gone), HasSubstr("refers to \"gone.png\", a file that does not"));
  write("m.mtl", "newmtl m\nmap_Kd /x/wood.png\nmap_Ke /y/wood.png\n");
  EXPECT_THAT(load("mtllib m.mtl\n" + three_corners + textured_face).warnings,
              ElementsAre(HasSubstr("/x/wood.png and a file of the same name in another folder")));
  write("m.mtl", "newmtl m\n");
  EXPECT_THAT(load("mtllib /x/m.mtl\nmtllib D:\\m.mtl\n" + three_corners + textured_face).warnings,
              ElementsAre(HasSubstr("/x/m.mtl and a file of the same name in another folder")));
}

TEST_F(ForeignObj, TexturesThatCannotBeHadAreLeftOut) {
  write("text.tga", "this is no image");
  write("m.mtl", "newmtl m\nmap_Kd gone.png\nmap_d gone.png\nmap_Ke text.tga\nmap_Pr gone.png\n");
  const Scene scene = load("mtllib m.mtl\n" + three_corners + textured_face);
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.base_color, Rgb(1.0F));
  EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
  EXPECT_FALSE(material.base_color_texture.exists());
  EXPECT_FALSE(material.metallic_roughness_texture.exists());
  EXPECT_FALSE(material.emissive_texture.exists());
  EXPECT_TRUE(scene.textures.empty());
  EXPECT_TRUE(scene.files.contains(folder() / "gone.png")) << "it may come yet";
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("a texture is left out: gone.png does not exist (3 times"),
                          AllOf(HasSubstr("a texture is left out: "), HasSubstr("text.tga"))));
  EXPECT_THAT(strict_error_of("mtllib m.mtl\n" + three_corners + textured_face),
              HasSubstr("m.mtl: m: refers to \"gone.png\", a file that does not exist"));
}

TEST_F(ForeignObj, AMissingLibraryIsLeftOut) {
  const std::string obj = "mtllib gone.mtl\n" + three_corners + "usemtl m\nf 1 2 3\n";
  const Scene scene = load(obj);
  EXPECT_THAT(scene.warnings,
              ElementsAre("a material library is left out: gone.mtl does not exist",
                          HasSubstr("a material that no library describes is white")));
  EXPECT_TRUE(scene.files.contains(folder() / "gone.mtl")) << "it may come yet";
  EXPECT_THAT(strict_error_of(obj), HasSubstr("scene.obj: mtllib: refers to \"gone.mtl\""));
}

/// Written on a system with other paths: in a folder, with a backslash, in another case.
TEST_F(ForeignObj, FindsTexturesAsOtherSystemsNameThem) {
  write("Maps/Red.TGA", encoded_image({"targa", 1, 1, 3, std::vector<std::uint8_t>{255, 0, 0}}));
  write("Sub/m.mtl", "newmtl m\nmap_Kd ..\\maps\\red.tga\n");
  write("m.mtl", "newmtl m\nmap_Kd MAPS\\red.tga\n");
  const Scene scene = load("mtllib M.MTL\n" + three_corners + textured_face);
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_EQ(scene.textures.at(0).sample({0, 0}), Vec4(1, 0, 0, 1));
  const Scene other = load("mtllib Sub\\m.mtl\n" + three_corners + textured_face);
  EXPECT_THAT(other.warnings, IsEmpty()) << "from Sub into the folder";
  EXPECT_EQ(other.textures.at(0).sample({0, 0}), Vec4(1, 0, 0, 1));
}

TEST_F(ForeignObj, TexturesOutOfTheFolderAreThoseBesideTheLibraryOrTheScene) {
  const std::string obj = "mtllib Sub/m.mtl\n" + three_corners + textured_face;
  write("Sub/m.mtl", "newmtl m\nmap_Kd ../../textures/w.png\n");
  EXPECT_THAT(load(obj).warnings, ElementsAre(HasSubstr("w.png does not exist")));
  EXPECT_THAT(strict_error_of(obj), HasSubstr("\"w.png\", a file that does not exist"));
  write("w.png", one_pixel(255, 0, 0));
  EXPECT_EQ(load(obj).textures.at(0).sample({0, 0}), Vec4(1, 0, 0, 1));
  write("Sub/w.png", one_pixel(0, 0, 255));
  EXPECT_EQ(load(obj).textures.at(0).sample({0, 0}), Vec4(0, 0, 1, 1));
}

TEST_F(ForeignObj, WhatIsKeptOfAnImageIsNotDecodedAgain) {
  const auto image_of = [](std::uint8_t red) {
    return encoded_image({"targa", 1, 1, 3, std::vector<std::uint8_t>{red, 0, 0}});
  };
  write("red.tga", image_of(255));
  write("m.mtl", "newmtl m\nmap_Kd red.tga\n");
  KeptSceneParts kept;
  const auto load_again = [&] {
    return load_obj(write("scene.obj", "mtllib m.mtl\n" + three_corners + textured_face),
                    {.kept = &kept});
  };
  const Scene first = load_again();
  const Scene again = load_again();
  EXPECT_EQ(&again.textures.at(0).texels(), &first.textures.at(0).texels());
  write("red.tga", image_of(0));
  EXPECT_EQ(load_again().textures.at(0).sample({0, 0}), Vec4(0, 0, 0, 1));
}

/// sRGB, as Blender and MeshLab write them: 0.5 is 0.21404 of full light (IEC 61966-2-1).
TEST_F(ForeignObj, VertexColoursAreSrgb) {
  const Scene scene = load("v 0 0 0 1 0.5 0\nv 1 0 0 1 1 1\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THAT(scene.warnings, IsEmpty());
  const std::vector<Vec4>& colors = scene.meshes.at(0).colors;
  ASSERT_EQ(colors.size(), 3U);
  EXPECT_NEAR(colors[0].g, 0.21404F, 1e-5F);
  EXPECT_EQ(colors[1], Vec4(1.0F));
  EXPECT_EQ(colors[2], Vec4(1.0F)) << "white where there is none";
  EXPECT_TRUE(load("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").meshes.at(0).colors.empty())
      << "a weight is no colour";
}

TEST_F(ForeignObj, ReadsUtf16) {
  const auto utf16 = [](const std::string& text) {
    std::string result = "\xFF\xFE";
    for (const char c : text) {
      result += {c, '\0'};
    }
    return result;
  };
  write("m.mtl", utf16("newmtl m\nKd 0 1 0\n"));
  const Scene scene = load(utf16("mtllib m.mtl\n" + three_corners + "usemtl m\nf 1 2 3\n"));
  EXPECT_EQ(scene.materials.at(0).base_color, Rgb(0, 1, 0));
  EXPECT_EQ(scene.triangle_count(), 1U);
}

}  // namespace
}  // namespace foveola::test
