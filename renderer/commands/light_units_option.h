// --light-units, for every command that takes a scene's name or file.
#pragma once

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Adds the option to `command`. What the returned finder finds has the units that the option said,
/// if it was given, in place of its own.
SceneFinder with_light_units(CLI::App& command, const SceneFinder& find_scene);

}  // namespace foveola
