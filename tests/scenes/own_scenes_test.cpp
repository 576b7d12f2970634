// Scenes of a user's own: descriptors beside their files, in the user's folder and beside a
// protocol.

#include "renderer/base/files/files.h"
#include "scenes/builtin.h"
#include "scenes/find_scene.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

using test::error_of;

std::string describing(const std::string& file, const std::string& title) {
  return "title = \"" + title + "\"\nfile = \"" + file +
         "\"\n[camera]\nposition = [1, 2, 3]\nazimuth_deg = 0\nelevation_deg = 0\n";
}

class OwnScenes : public testing::Test {
 protected:
  TemporaryFolder folder;
  fs::path study = folder / "study";
  fs::path users = folder / "data/foveola/scenes";

 private:
  EnvironmentVariable data_home_{"XDG_DATA_HOME", (folder / "data").string()};
  EnvironmentVariable scene_path_{"FOVEOLA_SCENE_PATH", ""};
};

TEST_F(OwnScenes, AFileTakesTheDescriptorBesideIt) {
  const fs::path file = folder.write("study/kitchen.glb", "x");
  const fs::path descriptor = folder.write("study/kitchen.toml", describing("kitchen.glb", "Mine"));
  const SceneSource source = find_scene(file.string());
  EXPECT_EQ(source.title, "Mine");
  EXPECT_EQ(source.name, file.string());
  EXPECT_EQ(source.file, file);
  EXPECT_EQ(source.camera_position, Vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(source.descriptor_beside, descriptor);
}

TEST_F(OwnScenes, ADescriptorBesideAFileComesBeforeTheProgramsOfThatFile) {
  const std::string file = folder.write("study/sponza_crytek.glb", "x").string();
  EXPECT_EQ(find_scene(file).title, "Crytek Sponza");
  EXPECT_TRUE(find_scene(file).descriptor_beside.empty());
  folder.write("study/sponza_crytek.toml", describing("sponza_crytek.glb", "Mine"));
  EXPECT_EQ(find_scene(file).title, "Mine");
}

TEST_F(OwnScenes, OtherTomlFilesBesideAFileAreNotItsDescriptor) {
  const std::string file = folder.write("study/kitchen.glb", "x").string();
  folder.write("study/kitchen.toml", "title = \"A study\"\nscenes = [\"kitchen\"]\n");
  EXPECT_EQ(find_scene(file).title, "kitchen");
  folder.write("study/kitchen.toml", describing("bathroom.glb", "Another"));
  EXPECT_EQ(find_scene(file).title, "kitchen");
}

TEST_F(OwnScenes, ABadDescriptorBesideAFileIsOneClearLine) {
  const std::string file = folder.write("study/kitchen.glb", "x").string();
  folder.write("study/kitchen.toml", describing("kitchen.glb", "Mine") + "colour = 3\n");
  EXPECT_THAT(error_of([&] { find_scene(file); }),
              AllOf(HasSubstr("kitchen.toml:7:1"), HasSubstr("colour")));
  folder.write("study/kitchen.toml", "title = ");
  EXPECT_THAT(error_of([&] { find_scene(file); }), HasSubstr("kitchen.toml:1:"));
}

TEST_F(OwnScenes, ADescriptorsPathNamesItsScene) {
  const fs::path file = folder.write("study/kitchen.glb", "x");
  const fs::path descriptor = folder.write("study/night.toml", describing("kitchen.glb", "Night"));
  const SceneSource source = find_scene(descriptor.string());
  EXPECT_EQ(source.title, "Night");
  EXPECT_EQ(source.file, fs::canonical(file));
  EXPECT_TRUE(source.descriptor_beside.empty());
}

TEST_F(OwnScenes, TheFileOfADescriptorLiesInItsFolder) {
  const std::string descriptor =
      folder.write("study/night.toml", describing("kitchen.glb", "Night")).string();
  EXPECT_THAT(error_of([&] { find_scene(descriptor); }),
              AllOf(HasSubstr("its scene 'kitchen.glb' is a file that does not exist"),
                    HasSubstr("put the file into")));
  fs::create_symlink(folder.write("elsewhere/kitchen.glb", "x"), study / "kitchen.glb");
  EXPECT_THAT(error_of([&] { find_scene(descriptor); }), HasSubstr("leads out of the folder"));
}

TEST_F(OwnScenes, AProtocolsSceneIsLookedForInThreePlaces) {
  EXPECT_EQ(find_scene_beside("meeting-room", study).title, "Meeting room");
  folder.write("data/foveola/scenes/mine.glb", "x");
  folder.write("data/foveola/scenes/meeting-room.toml", describing("mine.glb", "The user's"));
  EXPECT_EQ(find_scene_beside("meeting-room", study).title, "The user's");
  EXPECT_EQ(find_scene("meeting-room").title, "The user's");
  folder.write("study/near.glb", "x");
  folder.write("study/meeting-room.toml", describing("near.glb", "The study's"));
  EXPECT_EQ(find_scene_beside("meeting-room", study).title, "The study's");
  EXPECT_EQ(find_scene_beside("meeting-room", study).name, "meeting-room");
  EXPECT_EQ(find_scene("meeting-room").title, "The user's");
}

TEST_F(OwnScenes, TheProgramsProtocolsMeanTheProgramsScenes) {
  folder.write("data/foveola/scenes/mine.glb", "x");
  folder.write("data/foveola/scenes/meeting-room.toml", describing("mine.glb", "The user's"));
  EXPECT_EQ(find_scene_beside("meeting-room", resource_folder() / "protocols").title,
            "Meeting room");
}

TEST_F(OwnScenes, AProtocolOfASceneNameIsNoDescriptorOfIt) {
  folder.write("study/meeting-room.toml", "title = \"A study\"\nscenes = [\"meeting-room\"]\n");
  EXPECT_EQ(find_scene_beside("meeting-room", study).title, "Meeting room");
}

TEST_F(OwnScenes, ANameStandsForASceneFileToo) {
  folder.write("study/kitchen.obj", "x");
  EXPECT_EQ(find_scene_beside("kitchen", study).file, study / "kitchen.obj");
  folder.write("data/foveola/scenes/bathroom.glb", "x");
  EXPECT_EQ(find_scene_beside("bathroom", study).file, users / "bathroom.glb");
  EXPECT_EQ(find_scene("bathroom").file, users / "bathroom.glb");
}

/// A fetched scene of the published study is not a file without a description.
TEST_F(OwnScenes, AFetchedFileDoesNotHideItsDescriptor) {
  folder.write("data/foveola/scenes/bmw.glb", "x");
  EXPECT_TRUE(find_scene("bmw").camera_position.has_value());
}

TEST_F(OwnScenes, AProtocolsPathsBeginInItsFolder) {
  const fs::path file = folder.write("study/parts/kitchen.glb", "x");
  EXPECT_EQ(find_scene_beside("parts/kitchen.glb", study).file, file);
  EXPECT_EQ(find_scene_beside(file.string(), folder / "elsewhere").file, file);
  folder.write("study/parts/night.toml", describing("kitchen.glb", "Night"));
  EXPECT_EQ(find_scene_beside("parts/night.toml", study).title, "Night");
  EXPECT_THAT(error_of([&] { find_scene_beside("kitchen.glb", study); }),
              HasSubstr((study / "kitchen.glb").string() + ": is not a known scene or file"));
}

TEST_F(OwnScenes, ExtensionsAreKnownInAnyCase) {
  const fs::path file = folder.write("study/Kitchen.GLB", "x");
  EXPECT_EQ(find_scene_beside("Kitchen.GLB", study).file, file);
  folder.write("study/Kitchen.TOML", describing("Kitchen.GLB", "Mine"));
  EXPECT_EQ(find_scene_beside("Kitchen.TOML", study).title, "Mine");
}

TEST_F(OwnScenes, AnotherViewOfABuiltInSceneNeedsNoFile) {
  folder.write("study/meeting-room.toml",
               "title = \"From the door\"\nbuiltin = true\n[camera]\nposition = [1, 2, 3]\n"
               "azimuth_deg = 0\nelevation_deg = 0\n");
  const SceneSource source = find_scene_beside("meeting-room", study);
  EXPECT_EQ(source.title, "From the door");
  EXPECT_EQ(source.file, builtin_file("meeting-room"));
}

}  // namespace
}  // namespace foveola::scenes
