#include <fmt/format.h>

#include "renderer/base/files/digest.h"
#include "renderer/scene/load_scene.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

/// The nine floats of the triangle (0,0,0), (1,0,0), (0,1,0), in base64 (computed with coreutils).
const std::string triangle_in_base64 = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";

/// one_triangle as .gltf, its buffer at `uri`.
std::string gltf_with_buffer(const std::string& uri) {
  GlbBuilder glb = one_triangle();
  glb.document["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
  return glb.document.dump(2);
}

class GltfFiles : public LoadGltf {
 protected:
  Scene load_text(const std::string& text) const { return load_bytes(text, "scene.gltf"); }
  std::string error_of_text(const std::string& text) const {
    return error_of_bytes(text, "scene.gltf");
  }
};

TEST_F(GltfFiles, KnowsTheHashOfItsFile) {
  const std::string bytes = one_triangle().bytes();
  EXPECT_EQ(load_bytes(bytes).sha256, sha256(bytes));
}

/// Its buffer is in triangle.bin.
GlbBuilder with_image(const std::string& uri) { return textured_triangle("triangle.bin", uri); }

/// As `sha256sum scene.gltf a.png triangle.bin | cut -c-64 | sha256sum` has it.
TEST_F(GltfFiles, HashCoversTheFilesBesideIt) {
  GlbBuilder glb = with_image("a.png");
  const std::string text = glb.document.dump();
  const std::string image = one_pixel(1, 2, 3);
  write("triangle.bin", glb.buffer);
  write("a.png", image);
  const std::string before = load_text(text).sha256;
  EXPECT_EQ(before, sha256(sha256(text) + "\n" + sha256(image) + "\n" + sha256(glb.buffer) + "\n"));
  write("a.png", one_pixel(1, 2, 4));
  EXPECT_NE(load_text(text).sha256, before);
  write("a.png", image);
  glb.buffer.back() ^= 1;
  write("triangle.bin", glb.buffer);
  EXPECT_NE(load_text(text).sha256, before);
}

TEST_F(GltfFiles, ImagesThatNoMaterialUsesAreNotRead) {
  GlbBuilder glb = with_image("a.png");
  write("triangle.bin", glb.buffer);
  write("a.png", one_pixel(1, 2, 3));
  glb.add("images", {{"uri", "gone.png"}});
  glb.add("images", {{"uri", "text.png"}});
  glb.add("textures", {{"source", 1}});
  write("text.png", "this is no image");
  const Scene scene = load_text(glb.document.dump());
  EXPECT_EQ(scene.textures.size(), 1U);
  write("text.png", "nor is this");
  EXPECT_EQ(load_text(glb.document.dump()).sha256, scene.sha256);
}

TEST_F(GltfFiles, ReadsBuffersBesideTheScene) {
  write("tri angle+1.bin", one_triangle().buffer);
  EXPECT_EQ(load_text(gltf_with_buffer("tri%20angle+1.bin")).triangle_count(), 1U);
}

TEST_F(GltfFiles, ReadsBuffersOfBinariesBesideTheScene) {
  write("triangle.bin", one_triangle().buffer);
  const Scene scene = load_bytes(glb_container(gltf_with_buffer("triangle.bin"), ""));
  EXPECT_EQ(scene.triangle_count(), 1U);
}

TEST_F(GltfFiles, ReadsDataUris) {
  const Scene scene =
      load_text(gltf_with_buffer("data:application/octet-stream;base64," + triangle_in_base64));
  ASSERT_EQ(scene.triangle_count(), 1U);
  EXPECT_EQ(scene.meshes[0].positions[2], Vec3(0, 1, 0));
}

TEST_F(GltfFiles, ReadsImagesInDataUris) {
  const std::string red_png =
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/"
      "pLvAAAAAElFTkSuQmCC";
  for (const std::string type :
       {"image/png", "image/jpeg", "image/jpg", "IMAGE/PNG;charset=utf-8", "text/plain", ""}) {
    const GlbBuilder glb = with_image(fmt::format("data:{};base64,{}", type, red_png));
    write("triangle.bin", glb.buffer);
    const Scene scene = load_text(glb.document.dump());
    EXPECT_EQ(scene.textures.at(0).sample({0, 0}), Vec4(1, 0, 0, 1)) << type;
  }
}

TEST_F(GltfFiles, RefusesBuffersOfAnotherLength) {
  EXPECT_THAT(error_of_text(gltf_with_buffer("data:application/gltf-buffer;base64,AAAA")),
              HasSubstr("buffers[0]: size mismatch: it states 36 bytes, but there are 3"));
  write("short.bin", "abc");
  EXPECT_THAT(error_of_text(gltf_with_buffer("short.bin")), HasSubstr("size mismatch"));
  write("empty.bin", "");
  EXPECT_THAT(error_of_text(gltf_with_buffer("empty.bin")),
              HasSubstr("buffers[0].uri: refers to an empty file"));
}

TEST_F(GltfFiles, WhatFollowsABufferIsPadding) {
  write("long.bin", one_triangle().buffer + "padding");
  EXPECT_EQ(load_text(gltf_with_buffer("long.bin")).triangle_count(), 1U);
}

TEST_F(GltfFiles, BuffersThatNothingUsesNeedNoContent) {
  GlbBuilder glb = one_triangle();
  Json document = glb.document;
  document["buffers"] = {{{"byteLength", 36}}, {{"byteLength", 4294967295U}}};
  EXPECT_EQ(load_bytes(glb_container(document.dump(), glb.buffer)).triangle_count(), 1U);
  document["bufferViews"][0]["buffer"] = 1;
  EXPECT_THAT(error_of_bytes(glb_container(document.dump(), glb.buffer)),
              HasSubstr("buffers[1].uri: is missing: only the first buffer may lie in the file"));
}

TEST_F(GltfFiles, RefusesDataUrisThatCannotBeDecoded) {
  EXPECT_THAT(error_of_text(gltf_with_buffer("data:application/octet-stream;base64,AA*A")),
              HasSubstr("buffers[0].uri: is a data: uri that is not base64"));
  GlbBuilder glb = one_triangle();
  glb.add("images", {{"uri", "data:image/png;base64"}});
  EXPECT_THAT(error_of(glb), HasSubstr("images[0].uri: is a data: uri that is not base64"));
}

TEST_F(GltfFiles, NamesWhatIsMissing) {
  EXPECT_THAT(error_of_text(gltf_with_buffer("gone.bin")),
              HasSubstr("buffers[0].uri: refers to \"gone.bin\", a file that does not exist"));
  const GlbBuilder glb = with_image("gone.png");
  write("triangle.bin", glb.buffer);
  EXPECT_THAT(error_of_bytes(glb.document.dump(), "scene.gltf", {.strict = true}),
              HasSubstr("images[0].uri: refers to \"gone.png\", a file that does not"));
}

TEST_F(GltfFiles, RefusesImagesOutOfTheFolderWhetherTheyAreUsedOrNot) {
  fs::create_directory(folder() / "inner");
  write("red.png", one_pixel(255, 0, 0));
  fs::create_symlink("../red.png", folder() / "inner" / "link.png");
  for (const std::string& uri :
       {std::string("http:red.png"), std::string("link.png"), std::string("."), std::string()}) {
    GlbBuilder glb = one_triangle();
    glb.add("images", {{"uri", uri}});
    EXPECT_THAT(error_of_bytes(glb.bytes(), "inner/scene.glb"),
                HasSubstr("images[0].uri: refers to \""))
        << uri;
  }
}

TEST_F(GltfFiles, AcceptsALoneFileName) {
  const fs::path before = fs::current_path();
  write("triangle.bin", one_triangle().buffer);
  write("scene.gltf", gltf_with_buffer("triangle.bin"));
  fs::current_path(folder());
  EXPECT_NO_THROW(load_gltf("scene.gltf"));
  fs::current_path(before);
}

TEST_F(GltfFiles, RefusesAGltfWithoutABufferUri) {
  EXPECT_THAT(error_of_text(one_triangle().document.dump()), HasSubstr("scene.gltf"));
}

TEST_F(GltfFiles, EveryTruncationIsAnError) {
  const std::string whole = one_triangle().bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THAT(error_of_bytes(whole.substr(0, size)), HasSubstr("scene.glb"));
  }
  EXPECT_THAT(error_of_bytes(whole.substr(0, 100)), HasSubstr("truncated: its header announces"));
  EXPECT_THAT(error_of_bytes(whole.substr(0, 10)), HasSubstr("truncated: 10 bytes"));
}

TEST_F(GltfFiles, ChecksTheContainer) {
  const auto spoilt = [](std::size_t offset, char value) {
    std::string bytes = one_triangle().bytes();
    bytes[offset] = value;
    return bytes;
  };
  EXPECT_THAT(error_of_bytes(spoilt(0, 'x')), HasSubstr("does not begin with \"glTF\""));
  EXPECT_THAT(error_of_bytes(spoilt(4, 1)), HasSubstr("glTF binary version 1, not 2"));
  EXPECT_THAT(error_of_bytes(spoilt(15, 0x7F)), HasSubstr("the chunk at byte 12 ends after"));
  EXPECT_THAT(error_of_bytes(spoilt(16, 'X')), HasSubstr("the first chunk is not JSON"));
}

/// The eight bytes of the chunk's own header count as well.
TEST_F(GltfFiles, TheSecondChunkEndsInsideTheFile) {
  const GlbBuilder glb = one_triangle();
  std::string bytes = glb.bytes();
  const std::size_t chunk = bytes.size() - glb.buffer.size() - 8;
  bytes[chunk] = static_cast<char>(bytes[chunk] + 8);
  EXPECT_THAT(error_of_bytes(bytes), HasSubstr(" ends after the file's "));
}

TEST_F(GltfFiles, SaysThatSomethingElseIsNotGltf) {
  EXPECT_THAT(error_of_text("v 0 0 0\n"),
              HasSubstr("scene.gltf: line 1, column 1: this is not JSON"));
  EXPECT_THAT(error_of_text(R"({"name": "package"})"), HasSubstr("asset: is missing"));
}

TEST_F(GltfFiles, ErrorsAreOneShortLine) {
  const std::string error = error_of_text(
      gltf_with_buffer("data:application/octet-stream;base64," + std::string(100000, 'A') + "*"));
  EXPECT_THAT(error, AllOf(HasSubstr("scene.gltf"), Not(HasSubstr("\n"))));
  EXPECT_LT(error.size(), 600U);
}

}  // namespace
}  // namespace foveola::test
