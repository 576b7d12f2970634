#include "scenes/find_scene.h"

#include <sys/stat.h>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "scenes/builtin.h"
#include "scenes/descriptor_search.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"
#include "tests/unprivileged.h"

namespace foveola::scenes {
namespace {

class FindScene : public testing::Test {
 protected:
  std::string error_of(const std::string& name_or_path) {
    return test::error_of([&] { find_scene(name_or_path); });
  }

  TemporaryFolder folder;

 private:
  EnvironmentVariable data_home_{"XDG_DATA_HOME", (folder.path() / "data").string()};
  EnvironmentVariable scene_path_{"FOVEOLA_SCENE_PATH", (folder.path() / "real").string()};
};

TEST_F(FindScene, ABuiltinSceneIsAFile) {
  const SceneSource source = find_scene("meeting-room");
  EXPECT_EQ(source.name, "meeting-room");
  EXPECT_EQ(source.title, "Meeting room");
  EXPECT_TRUE(std::filesystem::is_regular_file(source.file));
  EXPECT_TRUE(source.camera_position.has_value());
}

TEST_F(FindScene, RealSceneIsFoundOnTheScenePath) {
  const auto file = folder.write("real/somewhere/bmw.glb", "x");
  const SceneSource source = find_scene("bmw");
  EXPECT_EQ(source.name, "bmw");
  EXPECT_EQ(source.file, file);
  EXPECT_TRUE(source.camera_position.has_value());
}

TEST_F(FindScene, MissingRealSceneNamesFileVariableAndCounterpart) {
  EXPECT_THAT(error_of("bmw"), AllOf(HasSubstr("bmw.glb"), HasSubstr("FOVEOLA_SCENE_PATH"),
                                     HasSubstr("studio-car")));
}

TEST_F(FindScene, PathTakesTheViewpointOfTheDescriptorThatNamesTheFile) {
  const std::string path = folder.write("mine/sponza_crytek.glb", "x").string();
  const SceneSource source = find_scene(path);
  EXPECT_EQ(source.name, path);
  EXPECT_EQ(source.file, path);
  EXPECT_TRUE(source.camera_position.has_value());
  EXPECT_FALSE(source.objects.empty());
}

TEST_F(FindScene, CopiesOfBuiltinScenesKeepTheirViewpoint) {
  const std::string glb = read_file(builtin_file("meeting-room"));
  const std::string copy = folder.write("mine/meeting-room.glb", glb).string();
  EXPECT_EQ(find_scene(copy).title, "Meeting room");
}

TEST_F(FindScene, OtherFilesOfABuiltinScenesNameAreNoCopies) {
  const SceneSource source = find_scene(folder.write("fake/church.glb", "x").string());
  EXPECT_EQ(source.title, "church");
  EXPECT_FALSE(source.camera_position.has_value());
}

TEST_F(FindScene, KnowsTheHashOfTheDescribedFile) {
  EXPECT_EQ(find_scene("meeting-room").described_sha256,
            sha256_of_file(builtin_file("meeting-room")));
  folder.write("real/bmw.glb", "x");
  EXPECT_EQ(find_scene("bmw").described_sha256, find_descriptor("bmw")->sha256);
}

TEST_F(FindScene, OtherFilesHaveNoViewpoint) {
  const std::string path = folder.write("kitchen.glb", "x").string();
  const SceneSource source = find_scene(path);
  EXPECT_EQ(source.title, "kitchen");
  EXPECT_EQ(source.file, path);
  EXPECT_FALSE(source.camera_position.has_value());
  EXPECT_TRUE(source.objects.empty());
}

TEST_F(FindScene, UnknownNameListsTheBuiltinScenes) {
  EXPECT_THAT(
      error_of("castle"),
      AllOf(HasSubstr("castle"), HasSubstr("arcade, church, meeting-room, schoolroom, studio-car"),
            HasSubstr("FOVEOLA_SCENE_PATH")));
  EXPECT_THAT(error_of((folder.path() / "missing.glb").string()), HasSubstr("arcade"));
  EXPECT_THAT(error_of(""), HasSubstr("arcade"));
}

TEST_F(FindScene, AsksWhetherASimilarSceneWasMeant) {
  EXPECT_THAT(error_of("arcad"), HasSubstr("is not a known scene or file; did you mean 'arcade'?"));
  folder.write("data/foveola/scenes/kitchen.toml", "");
  EXPECT_THAT(error_of("kitchin"), HasSubstr("did you mean 'kitchen'?"));
}

TEST_F(FindScene, WhatIsNoFileIsRefused) {
  EXPECT_THAT(error_of(folder.path().string()), HasSubstr("is a folder"));
  const std::string pipe = (folder.path() / "pipe.glb").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(error_of(pipe), HasSubstr("is not a regular file"));
  EXPECT_THAT(error_of(std::string(300, 'x')), HasSubstr("is not a known scene or file"));
}

TEST_F(FindScene, LinksThatLeadNowhereAreNamedAsSuch) {
  const std::filesystem::path loop = folder / "loop.glb";
  std::filesystem::create_symlink(loop, loop);
  EXPECT_THAT(error_of(loop.string()), HasSubstr("is a broken link; correct the link"));
  const std::filesystem::path dangling = folder / "dangling.glb";
  std::filesystem::create_symlink("/nowhere/at/all", dangling);
  EXPECT_THAT(error_of(dangling.string()), HasSubstr("is a broken link; correct the link"));
}

TEST_F(FindScene, SaysWhatKeptItFromFindingARealScene) {
  std::filesystem::create_directories(folder / "real/bmw.glb");
  EXPECT_THAT(error_of("bmw"), HasSubstr("bmw.glb is a folder); see"));
}

TEST_F(FindScene, WhatIsOutOfReachIsNotUnknown) {
  const std::string file = folder.write("locked/bmw.glb", "x").string();
  test::open_to_all(folder.path());
  const test::Locked locked(folder / "locked");
  const test::Unprivileged unprivileged;
  EXPECT_THAT(error_of(file), HasSubstr("cannot be reached: Permission denied; check"));
}

}  // namespace
}  // namespace foveola::scenes
