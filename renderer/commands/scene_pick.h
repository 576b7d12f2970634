// `foveola scene pick`: what a gaze meets in a scene.
#pragma once

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Adds `pick` to the command `scene`; see add_renderer_commands.
void add_scene_pick(CLI::App& scene, const SceneFinder& find_scene);

}  // namespace foveola
