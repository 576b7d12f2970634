#include "renderer/commands/scene_file_options.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "renderer/commands/arguments.h"

namespace foveola {

void add_scene_file_options(CLI::App& command, SceneFileArguments& arguments) {
  command
      .add_option("--light-units", arguments.light_units,
                  "Units of a glTF file's punctual lights: photometric (lux and candela, divided "
                  "by 683 lm/W) or radiometric (unchanged); the default is photometric in files by "
                  "Blender's exporter from 3.4.40 on, and radiometric in others")
      ->check(CLI::IsMember(texts_of(light_unit_words)));
  command.add_flag(
      "--strict", arguments.strict,
      "Refuse a scene with a texture or a material library that is missing or cannot be "
      "read, which is otherwise left out with a warning");
  CLI::Option* const time =
      command.add_option("--time", arguments.time_s,
                         "Show a glTF file at this time of all its animations, in seconds "
                         "(default: without animation)");
  time->check([](const std::string& text) {
    return parse_finite_number(text) ? std::string() : "'" + text + "' is not a time in seconds";
  });
  command
      .add_option("--clip", arguments.clip,
                  "The only animation to apply at --time; scene info lists them")
      ->needs(time);
}

void apply_scene_file_options(const SceneFileArguments& arguments, SceneSource& source) {
  if (!arguments.light_units.empty()) {
    source.light_units = value_of(light_unit_words, arguments.light_units);
  }
  source.strict = source.strict || arguments.strict;
  if (arguments.time_s) {
    source.time_s = arguments.time_s;
    source.clip = arguments.clip;
  }
}

SceneFinder with_scene_file_options(CLI::App& command, const SceneFinder& find_scene) {
  const auto arguments = std::make_shared<SceneFileArguments>();
  add_scene_file_options(command, *arguments);
  return [arguments, find_scene](const std::string& name_or_path) {
    SceneSource source = find_scene(name_or_path);
    apply_scene_file_options(*arguments, source);
    return source;
  };
}

}  // namespace foveola
