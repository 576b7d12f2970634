#include "scenes/commands.h"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "scenes/builtin.h"
#include "scenes/descriptor_search.h"
#include "tests/scenes/environment.h"
#include "tests/unprivileged.h"

namespace foveola::scenes {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Its file has the content "abc" (FIPS 180-4 has the hash).
const char* const hall = R"(title = "A hall"
author = "Somebody"
licence = "CC BY 4.0"
file = "hall.glb"
sha256 = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
size_bytes = 3

[camera]
position = [1.0, 2.0, 3.0]
azimuth_deg = 90
elevation_deg = -10.0
)";

class SceneCommands : public testing::Test {
 protected:
  /// What the command line prints.
  static std::string output_of(const std::string& command_line) {
    CLI::App app("test", "foveola");
    add_scene_commands(app, {});
    testing::internal::CaptureStdout();
    try {
      app.parse(command_line);
    } catch (...) {
      testing::internal::GetCapturedStdout();
      throw;
    }
    return testing::internal::GetCapturedStdout();
  }

  TemporaryFolder folder;

 private:
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
  EXPECT_EQ(states.at("bmw"), "another file");
  EXPECT_EQ(states.at("sponza"), "missing");
  const std::string text = output_of("scene list");
  EXPECT_THAT(text, HasSubstr((folder.path() / "real" / "bmw.glb").string()));
  EXPECT_THAT(text, HasSubstr("Arcade"));
  EXPECT_THAT(text, HasSubstr(builtin_file("arcade").string()));
  EXPECT_THAT(text, HasSubstr("(built-in counterpart: studio-car)"));
}

/// With a descriptor of its own, since nobody may ship the originals.
TEST_F(SceneCommands, ListKnowsTheDescribedFile) {
  const EnvironmentVariable resources("FOVEOLA_RESOURCES", (folder.path() / "share").string());
  folder.write("share/protocols/none.toml", "");
  folder.write("share/scenes/hall.toml", hall);
  folder.write("real/hall.glb", "abc");
  EXPECT_THAT(output_of("scene list"), HasSubstr("hall           real "));
  folder.write("real/hall.glb", "abd");
  EXPECT_THAT(output_of("scene list"), HasSubstr("hall           another file "));
}

TEST_F(SceneCommands, ABrokenDescriptorDoesNotBreakTheList) {
  const EnvironmentVariable resources("FOVEOLA_RESOURCES", (folder.path() / "share").string());
  folder.write("share/protocols/none.toml", "");
  folder.write("share/scenes/broken.toml", "title = 7\n");
  folder.write("share/scenes/hall.toml", hall);
  testing::internal::CaptureStderr();
  EXPECT_THAT(output_of("scene list"), HasSubstr("hall           missing "));
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              AllOf(HasSubstr("foveola: warning: "), HasSubstr("broken.toml:1:9")));
}

TEST_F(SceneCommands, ListWarnsOnceOfWhatHidesScenes) {
  folder.write("real", "a file");
  testing::internal::CaptureStderr();
  EXPECT_THAT(output_of("scene list"), HasSubstr("sponza         missing "));
  const std::string warnings = testing::internal::GetCapturedStderr();
  EXPECT_EQ(warnings, "foveola: warning: " + (folder / "real").string() +
                          ": Not a directory; mend it, or remove it from FOVEOLA_SCENE_PATH\n");
}

TEST_F(SceneCommands, ListKnowsFilesThatMayNotBeRead) {
  const EnvironmentVariable resources("FOVEOLA_RESOURCES", (folder / "share").string());
  folder.write("share/protocols/none.toml", "");
  folder.write("share/scenes/hall.toml", hall);
  const test::Locked locked(folder.write("real/hall.glb", "x"));
  test::open_to_all(folder.path());
  const test::Unprivileged unprivileged;
  EXPECT_THAT(output_of("scene list"), HasSubstr("hall           unreadable "));
}

TEST_F(SceneCommands, FetchTakesAConversionOnlyWhenAskedForAndWarns) {
  const EnvironmentVariable data_home("XDG_DATA_HOME", (folder.path() / "data").string());
  const std::string glb("glTF\2\0\0\0\24\0\0\0JSON{}  ", 20);
  const std::string own = folder.write("own.glb", glb).string();
  EXPECT_THROW(output_of("scene fetch sponza --from " + own), Error);
  testing::internal::CaptureStderr();
  EXPECT_THAT(output_of("scene fetch sponza --unverified --from " + own),
              HasSubstr("Licence: CC BY 3.0"));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("foveola: warning: "));
  EXPECT_THROW(output_of("scene fetch sponza --unverified"), CLI::RequiresError);
}

TEST_F(SceneCommands, FetchTakesOnesOwnDescriptorByNameAndByFile) {
  const EnvironmentVariable data_home("XDG_DATA_HOME", (folder.path() / "data").string());
  const std::string document = folder.write("elsewhere/hall.glb", "abc").string();
  folder.write("data/foveola/scenes/hall.toml", hall);
  EXPECT_THAT(output_of("scene fetch hall --from " + document),
              HasSubstr((folder / "data/foveola/scenes/hall.glb").string()));
  const std::string descriptor = folder.write("mine/hall.toml", hall).string();
  EXPECT_THAT(output_of("scene fetch " + descriptor + " --from " + document),
              HasSubstr((folder / "mine/hall.glb").string()));
  EXPECT_EQ(read_file(folder / "mine/hall.glb"), "abc");
}

TEST_F(SceneCommands, NoneIsAUsageError) {
  CLI::App app("test", "foveola");
  add_scene_commands(app, {});
  EXPECT_THROW(app.parse("scene"), CLI::RequiredError);
}

}  // namespace
}  // namespace foveola::scenes
