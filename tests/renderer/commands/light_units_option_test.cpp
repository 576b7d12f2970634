#include "renderer/commands/light_units_option.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace foveola::test {
namespace {

SceneSource found_by(const std::string& command_line, std::optional<LightUnits> described) {
  CLI::App app;
  const SceneFinder find = with_light_units(app, [described](const std::string& name) {
    SceneSource source;
    source.name = name;
    source.light_units = described;
    return source;
  });
  app.parse(command_line);
  return find("hall");
}

TEST(LightUnitsOption, ComesBeforeTheDescriptor) {
  EXPECT_EQ(found_by("--light-units photometric", LightUnits::radiometric).light_units,
            LightUnits::photometric);
  EXPECT_EQ(found_by("--light-units radiometric", std::nullopt).light_units,
            LightUnits::radiometric);
  EXPECT_EQ(found_by("--light-units radiometric", std::nullopt).name, "hall");
}

TEST(LightUnitsOption, LeavesTheSceneAloneWhereItIsNotGiven) {
  EXPECT_EQ(found_by("", LightUnits::photometric).light_units, LightUnits::photometric);
  EXPECT_EQ(found_by("", std::nullopt).light_units, std::nullopt);
}

TEST(LightUnitsOption, RefusesOtherWords) {
  EXPECT_THROW(found_by("--light-units lumen", std::nullopt), CLI::ParseError);
}

}  // namespace
}  // namespace foveola::test
