#include "renderer/commands/light_units_option.h"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace foveola {

void add_light_units_option(CLI::App& command, std::string& units) {
  command
      .add_option(
          "--light-units", units,
          "Units of a glTF file's punctual lights: photometric (lux and candela, divided by "
          "683 lm/W) or radiometric (taken as they are); the default is photometric in "
          "files by Blender's exporter from 3.4.40 on, and radiometric in others")
      ->check(CLI::IsMember({"photometric", "radiometric"}));
}

void set_light_units(const std::string& units, SceneSource& source) {
  if (!units.empty()) {
    source.light_units = units == "photometric" ? LightUnits::photometric : LightUnits::radiometric;
  }
}

SceneFinder with_light_units(CLI::App& command, const SceneFinder& find_scene) {
  const auto units = std::make_shared<std::string>();
  add_light_units_option(command, *units);
  return [units, find_scene](const std::string& name_or_path) {
    SceneSource source = find_scene(name_or_path);
    set_light_units(*units, source);
    return source;
  };
}

}  // namespace foveola
