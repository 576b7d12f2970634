#include "renderer/commands/scene_file_options.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace foveola::test {
namespace {

SceneSource found_by(const std::string& command_line, std::optional<LightUnits> described) {
  CLI::App app;
  const SceneFinder find = with_scene_file_options(app, [described](const std::string& name) {
    SceneSource source;
    source.name = name;
    source.light_units = described;
    return source;
  });
  app.parse(command_line);
  return find("hall");
}

TEST(SceneFileOptions, ComeBeforeTheDescriptor) {
  EXPECT_EQ(found_by("--light-units photometric", LightUnits::radiometric).light_units,
            LightUnits::photometric);
  EXPECT_EQ(found_by("--light-units radiometric", std::nullopt).light_units,
            LightUnits::radiometric);
  EXPECT_EQ(found_by("--light-units radiometric", std::nullopt).name, "hall");
}

TEST(SceneFileOptions, LeaveTheSceneAloneWhereTheyAreNotGiven) {
  EXPECT_EQ(found_by("", LightUnits::photometric).light_units, LightUnits::photometric);
  EXPECT_EQ(found_by("", std::nullopt).light_units, std::nullopt);
}

TEST(SceneFileOptions, SayWhetherWhatIsMissingIsAnError) {
  EXPECT_FALSE(found_by("", std::nullopt).strict);
  EXPECT_TRUE(found_by("--strict", std::nullopt).strict);
}

TEST(SceneFileOptions, SayWhenInTheAnimationsItIs) {
  EXPECT_EQ(found_by("", std::nullopt).time_s, std::nullopt);
  EXPECT_EQ(found_by("--time 1.5", std::nullopt).time_s, 1.5);
  EXPECT_THROW(found_by("--time nan", std::nullopt), CLI::ParseError);
}

}  // namespace
}  // namespace foveola::test
