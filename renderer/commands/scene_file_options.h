// The options --light-units, --strict, --time and --clip, for every command with a scene's name or
// file: how to read the file.
#pragma once

#include <optional>
#include <string>

#include "renderer/base/scene_source.h"
#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// As typed; empty if the option was not given.
struct SceneFileArguments {
  std::string light_units;
  bool strict = false;
  std::optional<double> time_s;
  std::string clip;
};

/// Adds the options to `command`; `arguments` must outlive it.
void add_scene_file_options(CLI::App& command, SceneFileArguments& arguments);

/// Applies the typed options to the reading of the scene's file.
void apply_scene_file_options(const SceneFileArguments& arguments, SceneSource& source);

/// Adds the options to `command`. The returned finder's scenes are read with the given options,
/// which override their own.
SceneFinder with_scene_file_options(CLI::App& command, const SceneFinder& find_scene);

}  // namespace foveola
