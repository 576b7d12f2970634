#include "renderer/progressive/loaded_scene.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/encoded_image.h"
#include "tests/renderer/scene/glb_builder.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"

namespace foveola {
namespace {

namespace fs = std::filesystem;

/// A triangle that is `size` wide, 5 m in front of (0, 0, 0).
std::string triangle_glb(float size, float shift = 0.0F) {
  test::GlbBuilder glb;
  const int positions = glb.add_vectors({{0, 0, -5}, {size, 0, -5}, {0, size, -5}});
  glb.add_root({{"mesh", glb.add_mesh({{"attributes", {{"POSITION", positions}}}})},
                {"translation", {shift, 0.0F, 0.0F}}});
  return glb.bytes();
}

class SceneReload : public ::testing::Test {
 protected:
  void replace(const std::string& bytes) const { fs::rename(folder_.write("new", bytes), file_); }

  SceneSource source() const { return {.name = "scene", .file = file_}; }

  /// What comes of the change that was made.
  static ReloadedScene wait_for(SceneReloader& reloader) {
    std::optional<ReloadedScene> reloaded;
    test::wait_until("the scene is loaded again", [&] {
      reloaded = reloader.take();
      return reloaded.has_value();
    });
    return *reloaded;
  }

  test::TemporaryFolder folder_;
  fs::path file_ = folder_.write("scene.glb", triangle_glb(1.0F));
  Workers workers_{2};
  KeptForReload kept_;
  LoadedScene first_{source(), workers_, {}, &kept_};
  SceneReloader reloader_{
      first_, kept_, {.find_source = [this] { return source(); }, .threads = 2}};
};

TEST_F(SceneReload, LoadsWhatChanged) {
  EXPECT_FALSE(reloader_.take());
  replace(triangle_glb(3.0F));
  const ReloadedScene reloaded = wait_for(reloader_);
  ASSERT_NE(reloaded.scene, nullptr) << reloaded.refusal;
  EXPECT_EQ(reloaded.scene->scene.bounds().upper, Vec3(3, 3, -5));
  EXPECT_FALSE(reloader_.take()) << "once";
}

TEST_F(SceneReload, WhatDoesNotLoadIsRefusedAndTheNextVersionIsLoaded) {
  replace("not a scene");
  const ReloadedScene refused = wait_for(reloader_);
  EXPECT_EQ(refused.scene, nullptr);
  EXPECT_NE(refused.refusal.find("scene.glb"), std::string::npos) << refused.refusal;
  replace(triangle_glb(2.0F));
  const ReloadedScene reloaded = wait_for(reloader_);
  ASSERT_NE(reloaded.scene, nullptr) << reloaded.refusal;
  EXPECT_EQ(reloaded.scene->scene.bounds().upper, Vec3(2, 2, -5));
}

TEST_F(SceneReload, AFileThatIsGoneIsRefusedAndFollowedByItsName) {
  fs::rename(file_, folder_ / "elsewhere.glb");
  const ReloadedScene gone = wait_for(reloader_);
  EXPECT_EQ(gone.scene, nullptr);
  EXPECT_NE(gone.refusal.find("scene.glb"), std::string::npos) << gone.refusal;
  replace(triangle_glb(2.0F));
  EXPECT_NE(wait_for(reloader_).scene, nullptr);
}

TEST_F(SceneReload, WhatOnlyMovedIsNotBuiltAgain) {
  replace(triangle_glb(1.0F, 1.0F));
  const ReloadedScene first_change = wait_for(reloader_);
  ASSERT_NE(first_change.scene, nullptr) << first_change.refusal;
  const std::uint64_t built = kept_.hierarchies.built();
  EXPECT_EQ(built, 1U);
  replace(triangle_glb(1.0F, 2.0F));
  const ReloadedScene moved = wait_for(reloader_);
  ASSERT_NE(moved.scene, nullptr) << moved.refusal;
  EXPECT_EQ(kept_.hierarchies.built(), built);
  EXPECT_EQ(moved.scene->scene.bounds().upper, Vec3(3, 1, -5));
  const auto picked = moved.scene->tracer.pick(Vec3(0.0F), glm::normalize(Vec3(2.1F, 0.1F, -5.0F)));
  EXPECT_TRUE(picked.has_value());
  EXPECT_FALSE(moved.scene->tracer.pick(Vec3(0.0F), glm::normalize(Vec3(0.1F, 0.1F, -5.0F))));
  replace(triangle_glb(2.0F, 2.0F));
  ASSERT_NE(wait_for(reloader_).scene, nullptr);
  EXPECT_EQ(kept_.hierarchies.built(), built + 1);
}

TEST_F(SceneReload, FollowsADescriptorThatIsWrittenBesideTheScene) {
  folder_.write("scene.toml", "title = 'x'");
  EXPECT_NE(wait_for(reloader_).scene, nullptr);
}

TEST_F(SceneReload, LoadsWhatWasMissingOnceItIsThere) {
  test::GlbBuilder glb = test::one_triangle();
  glb.document["buffers"] = {{{"uri", "buffer.bin"}, {"byteLength", glb.buffer.size()}}};
  const std::string with_a_buffer_of_its_own = glb.document.dump();
  const fs::path file = folder_.write("other.gltf", triangle_glb(1.0F));
  const auto find_other = [&] { return SceneSource{.name = "other", .file = file}; };
  KeptForReload kept;
  const LoadedScene first(find_other(), workers_, {}, &kept);
  SceneReloader reloader(first, kept, {.find_source = find_other});
  fs::rename(folder_.write("new", with_a_buffer_of_its_own), file);
  EXPECT_EQ(wait_for(reloader).scene, nullptr) << "the buffer is missing";
  fs::rename(folder_.write("new", glb.buffer), folder_ / "buffer.bin");
  EXPECT_NE(wait_for(reloader).scene, nullptr);
}

TEST_F(SceneReload, ShowsATextureThatWasMissingOnceItIsThere) {
  folder_.write("m.mtl", "newmtl m\nmap_Kd maps\\red.tga\n");
  fs::create_directory(folder_ / "maps");
  const fs::path file = folder_.write(
      "textured.obj",
      "mtllib m.mtl\nv 0 0 -5\nv 1 0 -5\nv 0 1 -5\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
  const auto find_textured = [&] { return SceneSource{.name = "textured", .file = file}; };
  KeptForReload kept;
  const LoadedScene first(find_textured(), workers_, {}, &kept);
  EXPECT_TRUE(first.scene.textures.empty());
  SceneReloader reloader(first, kept, {.find_source = find_textured});
  folder_.write("maps/red.tga",
                test::encoded_image({"targa", 1, 1, 3, std::vector<std::uint8_t>{255, 0, 0}}));
  const ReloadedScene reloaded = wait_for(reloader);
  ASSERT_NE(reloaded.scene, nullptr) << reloaded.refusal;
  EXPECT_EQ(reloaded.scene->scene.textures.size(), 1U);
}

// Objects far from the file's origin are seen from an origin of their own, which may change.
TEST_F(SceneReload, IsTheSceneThatLoadingAnewGives) {
  replace(triangle_glb(2.0F, 1000.0F));
  const ReloadedScene reloaded = wait_for(reloader_);
  ASSERT_NE(reloaded.scene, nullptr) << reloaded.refusal;
  const LoadedScene anew(source(), workers_);
  const Scene& scene = reloaded.scene->scene;
  EXPECT_EQ(scene.origin, anew.scene.origin);
  EXPECT_EQ(scene.bounds().upper, anew.scene.bounds().upper);
  EXPECT_EQ(scene.sha256, anew.scene.sha256);
  EXPECT_EQ(scene.triangle_count(), anew.scene.triangle_count());
  EXPECT_EQ(scene.meshes.size(), 0U) << "all are instances";
}

}  // namespace
}  // namespace foveola
