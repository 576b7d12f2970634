// `foveola scene info`: what a scene contains.
#pragma once

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Adds `info` to the command `scene`; see add_renderer_commands.
void add_scene_info(CLI::App& scene, const SceneFinder& find_scene);

}  // namespace foveola
