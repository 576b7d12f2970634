#include "scenes/commands.h"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/digest.h"
#include "scenes/builtin.h"
#include "tests/scenes/environment.h"

namespace foveola::scenes {
namespace {

using testing::HasSubstr;

class SceneCommands : public testing::Test {
 protected:
  /// What the command line prints.
  static std::string output_of(const std::string& command_line) {
    CLI::App app("test", "foveola");
    add_scene_commands(app, {});
    testing::internal::CaptureStdout();
    app.parse(command_line);
    return testing::internal::GetCapturedStdout();
  }

  TemporaryFolder folder;

 private:
  EnvironmentVariable cache_home_{"XDG_CACHE_HOME", (folder.path() / "cache").string()};
  EnvironmentVariable scene_path_{"FOVEOLA_SCENE_PATH", (folder.path() / "real").string()};
};

TEST_F(SceneCommands, ListShowsEveryState) {
  folder.write("real/bmw.glb", "x");
  nlohmann::json states;
  for (const nlohmann::json& scene : nlohmann::json::parse(output_of("scene list --json"))) {
    states[scene.at("name").get<std::string>()] = scene.at("state");
    EXPECT_FALSE(scene.at("licence").get<std::string>().empty());
  }
  EXPECT_EQ(states.at("arcade"), "built-in");
  EXPECT_EQ(states.at("bmw"), "real");
  EXPECT_EQ(states.at("sponza"), "missing");
  const std::string text = output_of("scene list");
  EXPECT_THAT(text, HasSubstr((folder.path() / "real" / "bmw.glb").string()));
  EXPECT_THAT(text, HasSubstr("Arcade"));
}

TEST_F(SceneCommands, MakeWritesFilesAndPrintsTheirHash) {
  const std::string text = output_of("scene make meeting-room -o " + folder.path().string());
  const std::filesystem::path file = folder.path() / "meeting-room.glb";
  EXPECT_THAT(text, HasSubstr(file.string()));
  EXPECT_THAT(text, HasSubstr(sha256_of_file(file)));
}

TEST_F(SceneCommands, MakeFillsTheCacheByDefault) {
  output_of("scene make meeting-room");
  EXPECT_TRUE(std::filesystem::exists(cached_builtin("meeting-room")));
}

TEST_F(SceneCommands, UnknownSceneIsAUsageError) {
  CLI::App app("test", "foveola");
  add_scene_commands(app, {});
  EXPECT_THROW(app.parse("scene make castle"), CLI::ValidationError);
  EXPECT_THROW(app.parse("scene"), CLI::RequiredError);
}

}  // namespace
}  // namespace foveola::scenes
