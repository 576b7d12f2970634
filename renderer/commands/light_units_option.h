// --light-units, for every command that takes a scene's name or file.
#pragma once

#include <string>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Adds the option to `command`; `units` holds what is typed, and must outlive it.
void add_light_units_option(CLI::App& command, std::string& units);

/// Gives the scene the units that were typed, if any were.
void set_light_units(const std::string& units, SceneSource& source);

/// Adds the option to `command`. What the returned finder finds has the units that the option said,
/// if it was given, in place of its own.
SceneFinder with_light_units(CLI::App& command, const SceneFinder& find_scene);

}  // namespace foveola
