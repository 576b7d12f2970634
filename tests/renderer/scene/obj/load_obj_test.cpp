#include <filesystem>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/files/digest.h"
#include "renderer/base/numbers/random.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/obj/obj_text.h"

namespace foveola::test {
namespace {

const std::string square_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class LoadObj : public ObjText {};

TEST_F(LoadObj, ReadsATriangle) {
  const std::string text = three_corners + "f 1 2 3\n";
  const Scene scene = load(text);
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_THAT(scene.meshes[0].positions, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
  EXPECT_THAT(scene.meshes[0].triangles, ElementsAre(std::array{0U, 1U, 2U}));
  EXPECT_THAT(scene.meshes[0].normals, IsEmpty());
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_EQ(scene.sha256, sha256(text));
  ASSERT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.materials[0].base_color, Rgb(1.0F));
  EXPECT_EQ(scene.materials[0].specular, 0.0F);
  EXPECT_TRUE(scene.materials[0].double_sided);
}

TEST_F(LoadObj, HashCoversLibrariesAndImages) {
  const std::string text = "mtllib m.mtl\n" + three_corners + "vt 0 0\nusemtl m\nf 1/1 2/1 3/1\n";
  const std::string library = "newmtl m\nmap_Kd a.png\n";
  const std::string image = one_pixel(1, 2, 3);
  write("m.mtl", library);
  write("a.png", image);
  const std::string before = load(text).sha256;
  EXPECT_EQ(before, sha256(sha256(text) + "\n" + sha256(image) + "\n" + sha256(library) + "\n"));
  write("m.mtl", library + "Kd 0 1 0\n");
  EXPECT_NE(load(text).sha256, before);
  write("m.mtl", library);
  write("a.png", one_pixel(1, 2, 4));
  EXPECT_NE(load(text).sha256, before);
}

TEST_F(LoadObj, NegativeIndicesCountBackwards) {
  const Scene scene = load(three_corners + "f -3 -2 -1\nv 5 5 5\nf -2 -3 -1\n");
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_THAT(scene.meshes[0].positions,
              ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(5, 5, 5)));
  EXPECT_THAT(scene.meshes[0].triangles,
              ElementsAre(std::array{0U, 1U, 2U}, std::array{2U, 1U, 3U}));
}

TEST_F(LoadObj, PolygonsAreCutIntoTriangles) {
  const Scene scene = load("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1 2 3 4 5\n");
  ASSERT_EQ(scene.triangle_count(), 3U);
  double area = 0.0;
  const Mesh& mesh = scene.meshes[0];
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    area += 0.5 * glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a).z;
  }
  EXPECT_NEAR(area, 4.0 - 0.5 * 2.0 * 1.5, 1e-6);
}

/// Of a cube with smooth normals: one vertex for each position and normal that go together.
TEST_F(LoadObj, VerticesAreSharedWhereAllTheirValuesAre) {
  const Scene scene = load(square_vertices + "v 2 0 0\nv 2 1 0\nvn 0 0 1\nvn 0 0.6 0.8\n" +
                           "f 1//1 2//1 3//1 4//1\nf 2//1 5//1 6//1 3//2\n");
  ASSERT_EQ(scene.meshes.size(), 1U);
  const Mesh& mesh = scene.meshes[0];
  EXPECT_EQ(mesh.positions.size(), 7U) << "six, and one more for the second normal at the third";
  ASSERT_EQ(mesh.normals.size(), 7U);
  EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
  EXPECT_EQ(mesh.normals.back(), Vec3(0, 0.6F, 0.8F));
}

TEST_F(LoadObj, FacesWithoutNormalsAmongOthersAreFlat) {
  const Scene scene = load(three_corners + "v 0 0 -1\nvn 0 0.6 0.8\nf 1//1 2//1 3//1\nf 1 4 2\n");
  const Mesh& mesh = scene.meshes.at(0);
  EXPECT_THAT(mesh.normals,
              ElementsAre(Vec3(0, 0.6F, 0.8F), Vec3(0, 0.6F, 0.8F), Vec3(0, 0.6F, 0.8F),
                          Vec3(0, -1, 0), Vec3(0, -1, 0), Vec3(0, -1, 0)));
}

TEST_F(LoadObj, UselessNormalsAreReplaced) {
  for (const std::string normal : {"0 0 0", "0 nan 1"}) {
    const Scene scene = load(three_corners + "vn " + normal + "\nf 1//1 2//1 3//1\n");
    EXPECT_THAT(scene.meshes.at(0).normals, Each(Vec3(0, 0, 1)));
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("invalid normals are replaced")));
  }
}

TEST_F(LoadObj, AMeshIsAnObjectInAMaterial) {
  const Scene scene =
      load(square_vertices +
           "o chair\ng seat\nf 1 2 3\nusemtl a\nf 1 3 4\no table\nf 1 2 4\nusemtl b\n" +
           "f 2 3 4\no chair\nusemtl a\nf 2 3 4\n");
  std::vector<std::pair<std::string, std::string>> names;
  for (const Mesh& mesh : scene.meshes) {
    names.emplace_back(mesh.name, scene.materials[static_cast<std::size_t>(mesh.material)].name);
  }
  ASSERT_EQ(scene.meshes.size(), 4U);
  EXPECT_EQ(scene.meshes[0].name, "chair");
  EXPECT_EQ(scene.meshes[1].name, "chair");
  EXPECT_EQ(scene.meshes[1].triangles.size(), 2U) << "the same object, taken up again";
  EXPECT_EQ(scene.meshes[2].name, "table");
  EXPECT_EQ(scene.meshes[1].material, scene.meshes[2].material);
  EXPECT_NE(scene.meshes[2].material, scene.meshes[3].material);
}

TEST_F(LoadObj, GroupsNameWhatNoObjectDoes) {
  const Scene scene = load(square_vertices + "g left wall\nf 1 2 3\ng right\nf 1 3 4\n");
  ASSERT_EQ(scene.meshes.size(), 2U);
  EXPECT_EQ(scene.meshes[0].name, "left");
  EXPECT_EQ(scene.meshes[1].name, "right");
}

TEST_F(LoadObj, DropsWhatCannotBeSeen) {
  const Scene scene =
      load(three_corners + "v nan 0 0\nv 1e39 0 0\nv 2 0 0\nf 1 2 3\nf 1 2 2\nf 1 2 6\n" +
           "f 1 2 5\nf 1 2\nf 1 2 4\n");
  EXPECT_EQ(scene.triangle_count(), 1U);
  EXPECT_EQ(scene.meshes.at(0).positions.size(), 3U);
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("faces of fewer than three corners are not shown (face 5)"),
                          HasSubstr("not finite are dropped (4 times")));
}

/// As C libraries print what is not finite, a decimal comma, and others.
TEST_F(LoadObj, WhatIsNoNumberIsNotZero) {
  for (const std::string text : {"nan", "NaN", "inf", "-inf", "-nan(ind)", "1.#QNAN", "1.#INF",
                                 "1,5", "0x10", "1d2", "e5", "1e", ".", "-", "1e9999999999"}) {
    const Scene scene = load(fmt::format("{}v {} 0 1\nf 1 2 3\nf 1 2 4\n", three_corners, text));
    EXPECT_EQ(scene.triangle_count(), 1U) << text;
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("not finite are dropped"))) << text;
  }
}

TEST_F(LoadObj, ReadsNumbersAsTheyAreWritten) {
  for (const std::string text : {"3", "+3", "3.", "3.0", ".3e1", "0.3E+01", "30e-1", "\t003 1 #"}) {
    const Scene scene = load(fmt::format("{}v 0 0 {}\nf 1 2 4\n", three_corners, text));
    ASSERT_EQ(scene.triangle_count(), 1U) << text;
    EXPECT_EQ(scene.meshes[0].positions[2], Vec3(0, 0, 3)) << text;
  }
  EXPECT_EQ(load(three_corners + "v 0 0 -1e-400\nf 3 2 4\n").meshes.at(0).positions.at(2),
            Vec3(0.0F));
}

TEST_F(LoadObj, EndsOfLinesAndContinuedLines) {
  for (const std::string& text :
       {std::string("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3"),
        std::string("\xEF\xBB\xBFv 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"),
        std::string("# text\n\nv 0 \\\n0 0\nv 1 0 0\nv 0 1 0\nf 1 \\\r\n 2 \\\n 3 \\\n")}) {
    EXPECT_EQ(load(text).triangle_count(), 1U) << text;
  }
}

TEST_F(LoadObj, AnEmptySceneLoadsAndSaysSo) {
  EXPECT_THAT(load("").warnings, ElementsAre("the scene has no triangles"));
  EXPECT_THAT(load("v 1 2 3\nl 1 1\np 1\n").warnings, ElementsAre("the scene has no triangles"));
}

TEST_F(LoadObj, RefusesIndicesOutOfRange) {
  const std::string where = (folder() / "scene.obj").string() + ": face 2: ";
  EXPECT_EQ(error_of(three_corners + "f 1 2 3\nf 1 2 4\n"),
            where + "names vertex 4, but 3 come before it; export it again");
  EXPECT_THAT(error_of(three_corners + "f 1 2 3\nf 1 2 -4\n"), HasSubstr("names vertex -4"));
  EXPECT_THAT(error_of(three_corners + "f 1 2 3\nf 0 1 2\n"), HasSubstr("names vertex 0"));
  EXPECT_THAT(error_of(three_corners + "f 1 2 3\nf x y z\n"), HasSubstr("names vertex 0"));
  EXPECT_THAT(error_of(three_corners + "vt 0 0\nf 1/2 2/1 3/1\n"),
              HasSubstr("names texture coordinate 2, but 1"));
  EXPECT_THAT(error_of(three_corners + "f 1//1 2//1 3//1\n"), HasSubstr("names normal 1, but 0"));
}

TEST_F(LoadObj, RefusesWhatIsNoText) {
  EXPECT_THAT(error_of(std::string("v 0 0\0 0", 8)), HasSubstr("is not a text file"));
  EXPECT_THROW(load_obj(folder() / "gone.obj"), Error);
  EXPECT_THROW(load_obj(folder()), Error);
}

TEST_F(LoadObj, FindsLibrariesAndTextures) {
  write("my library.mtl", "newmtl m\nmap_Kd textures\\100% red.png\n");
  write("textures/100% red.png", one_pixel(255, 0, 0));
  const Scene scene = load("mtllib my library.mtl\n" + three_corners + textured_face);
  EXPECT_THAT(scene.warnings, IsEmpty());
  ASSERT_EQ(scene.textures.size(), 1U);
  EXPECT_EQ(scene.textures[0].sample({0.5F, 0.5F}), Vec4(1, 0, 0, 1));
  EXPECT_EQ(scene.materials.at(0).base_color, Rgb(1.0F));
}

TEST_F(LoadObj, TexturesAreNamedFromTheirLibrarysFolder) {
  write("materials/m.mtl", "newmtl m\nKd 1 1 1\nmap_Kd red.png\n");
  write("other.mtl", "newmtl o\nKd 1 0 0\n");
  write("materials/red.png", one_pixel(255, 0, 0));
  const Scene scene = load("mtllib other.mtl materials\\m.mtl\n" + three_corners + textured_face);
  EXPECT_EQ(scene.textures.size(), 1U);
  EXPECT_EQ(scene.materials.size(), 1U) << "only what is used";
}

/// OBJ's v runs upwards: v = 1 is the image's first row.
TEST_F(LoadObj, TextureCoordinatesRunUpwards) {
  write("m.mtl", "newmtl m\nmap_Kd -s 2 4 1 -o 0.5 0.125 0 two.png\n");
  write("two.png", png(1, 2, 1, std::vector<std::uint8_t>{255, 0}));
  const Scene scene = load("mtllib m.mtl\n" + three_corners + textured_face);
  EXPECT_THAT(scene.meshes.at(0).uv_sets,
              ElementsAre(ElementsAre(Vec2(0, 1), Vec2(1, 1), Vec2(0, 0))));
  const TextureUse& use = scene.materials.at(0).base_color_texture;
  // The corner (u, v) = (1, 1) of OBJ lies at (2 + 0.5, 4 + 0.125) of the texture, v upwards.
  EXPECT_EQ(use.texture_from_mesh * Vec3(1, 0, 1), Vec2(2.5F, 1.0F - 4.125F));
  EXPECT_EQ(use.texture_from_mesh * Vec3(0, 1, 1), Vec2(0.5F, 1.0F - 0.125F));
}

TEST_F(LoadObj, TextureCoordinatesThatAreNoNumbersAreReplaced) {
  write("m.mtl", "newmtl m\nmap_Kd red.png\n");
  write("red.png", one_pixel(255, 0, 0));
  const Scene scene = load("mtllib m.mtl\n" + three_corners +
                           "vt 0.5 nan\nvt 1 0 nan\nvt 1 # v is 0\nusemtl m\nf 1/1 2/2 3/3\n");
  EXPECT_THAT(scene.meshes.at(0).uv_sets,
              ElementsAre(ElementsAre(Vec2(0, 0), Vec2(1, 1), Vec2(1, 1))));
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("texture coordinates that are not finite are replaced by 0")));
}

TEST_F(LoadObj, UntexturedSurfacesKeepNoCoordinates) {
  EXPECT_THAT(load(three_corners + textured_face).meshes.at(0).uv_sets, IsEmpty());
}

TEST_F(LoadObj, NormalTexturesBringTangents) {
  write("m.mtl", "newmtl m\nKd 1 1 1\nnorm n.png\n");
  write("n.png", one_pixel(128, 128, 255));
  const Scene scene = load("mtllib m.mtl\n" + three_corners + textured_face);
  const Mesh& mesh = scene.meshes.at(0);
  ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
  EXPECT_NEAR(mesh.tangents[0].x, 1.0F, 1e-6F) << "u grows along +X";
}

TEST_F(LoadObj, WarnsOfUnknownMaterials) {
  EXPECT_THAT(load(three_corners + "usemtl gone\nf 1 2 3\n").warnings,
              ElementsAre("a material that no library describes is white (gone)"));
}

TEST_F(LoadObj, ReadsNoFilesOutsideItsFolder) {
  const TemporaryFolder outside;
  outside.write("secret.mtl", "newmtl m\nKd 1 0 0\n");
  std::filesystem::create_symlink(outside / "secret.mtl", folder() / "link.mtl");
  const auto error = [&](const std::string& library) {
    return error_of("mtllib " + library + "\n" + three_corners + "usemtl m\nf 1 2 3\n");
  };
  const std::string elsewhere = (outside / "secret.mtl").string();
  for (const std::string& library :
       {std::string("../secret.mtl"), std::string("..\\secret.mtl"), elsewhere}) {
    EXPECT_THAT(load("mtllib " + library + "\n" + three_corners + "f 1 2 3\n").warnings,
                ElementsAre("a material library is left out: " + library + " does not exist"));
  }
  EXPECT_THAT(error("http://example.org/secret.mtl"), HasSubstr("not a relative path"));
  EXPECT_THAT(error("link.mtl"), HasSubstr("symbolic link"));
}

/// A texture of two images is as large as the larger, in four channels: 1 GiB here.
TEST_F(LoadObj, RefusesSmallImagesThatAskForMuchMemory) {
  write("m.mtl", "newmtl m\nmap_Kd red.png\nmap_d huge.png\n");
  write("red.png", one_pixel(255, 0, 0));
  write("huge.png", huge_png(100000));
  EXPECT_THAT(error_of("mtllib m.mtl\n" + three_corners + textured_face),
              HasSubstr("scene.obj: its textures would take 1024 MiB of memory, more than 256"));
}

/// Either a scene whose every index is in range, or an Error.
void expect_obj_or_error(const std::filesystem::path& path, const std::string& text) {
  try {
    const Scene scene = load_obj(path);
    for (const Mesh& mesh : scene.meshes) {
      ASSERT_LT(static_cast<std::size_t>(mesh.material), scene.materials.size()) << text;
      ASSERT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size()) << text;
      for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
          ASSERT_LT(vertex, mesh.positions.size()) << text;
          ASSERT_TRUE(is_finite(mesh.positions[vertex])) << text;
        }
      }
    }
  } catch (const Error&) {
  } catch (const std::exception& other) {
    ADD_FAILURE() << text << ": " << other.what();
  }
}

TEST_F(LoadObj, SurvivesOtherBytes) {
  write("red.png", one_pixel(255, 0, 0));
  const std::string mtl =
      "newmtl m\nKd 1 .5 0\nKs 1 1 1\nNs 9e1\nillum 2\nmap_Kd -clamp on red.png\n"
      "map_d red.png\nnewmtl n\nPr 0.5\nmap_Pr red.png\nnorm -bm 2 red.png\n";
  const std::string obj = "mtllib m.mtl\no a\n" + square_vertices + "vn 0 0 1\n" + textured_face +
                          "g b\nusemtl n\nf -4/1/1 -3/2/1 -2/3/1 -1/-1/-1\nf 1 2 3 4 1 2 3 4\n";
  const std::string alphabet = "0123456789-+.e/\\ \n\t\r\"#vfnotmKu\xFF";
  Pcg32 random(3);
  for (int i = 0; i < 2000; ++i) {
    std::string spoilt_mtl = mtl;
    std::string spoilt_obj = obj;
    for (int k = 0; k < 3; ++k) {
      std::string& text = random.below(3) == 0 ? spoilt_mtl : spoilt_obj;
      text[random.below(static_cast<std::uint32_t>(text.size()))] =
          alphabet[random.below(static_cast<std::uint32_t>(alphabet.size()))];
    }
    write("m.mtl", spoilt_mtl);
    expect_obj_or_error(write("spoilt.obj", spoilt_obj), spoilt_obj + spoilt_mtl);
  }
}

}  // namespace
}  // namespace foveola::test
