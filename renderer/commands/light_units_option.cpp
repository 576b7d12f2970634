#include "renderer/commands/light_units_option.h"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace foveola {

SceneFinder with_light_units(CLI::App& command, const SceneFinder& find_scene) {
  const auto units = std::make_shared<std::string>();
  command
      .add_option(
          "--light-units", *units,
          "Units of a glTF file's punctual lights: photometric (lux and candela, divided by "
          "683 lm/W) or radiometric (taken as they are); the default is photometric in "
          "files by Blender's exporter from 3.4.40 on, and radiometric in others")
      ->check(CLI::IsMember({"photometric", "radiometric"}));
  return [units, find_scene](const std::string& name_or_path) {
    SceneSource source = find_scene(name_or_path);
    if (!units->empty()) {
      source.light_units =
          *units == "photometric" ? LightUnits::photometric : LightUnits::radiometric;
    }
    return source;
  };
}

}  // namespace foveola
