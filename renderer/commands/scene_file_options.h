// --light-units, --strict, --time and --clip, for every command that takes a scene's name or file:
// how the file is read.
#pragma once

#include <optional>
#include <string>

#include "renderer/base/scene_source.h"
#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// As typed; empty where the option was not given.
struct SceneFileArguments {
  std::string light_units;
  bool strict = false;
  std::optional<double> time_s;
  std::string clip;
};

/// Adds the options to `command`; `arguments` must outlive it.
void add_scene_file_options(CLI::App& command, SceneFileArguments& arguments);

/// Has the scene's file read as was typed, in what was.
void apply_scene_file_options(const SceneFileArguments& arguments, SceneSource& source);

/// Adds the options to `command`. What the returned finder finds is read as the options say, in
/// place of what it says itself, where they are given.
SceneFinder with_scene_file_options(CLI::App& command, const SceneFinder& find_scene);

}  // namespace foveola
