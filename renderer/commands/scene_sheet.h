// `foveola scene sheet`: scenes side by side, for judging them by eye.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Adds `sheet` to the command `scene`; see add_renderer_commands. It shows `scenes` unless others
/// are named.
void add_scene_sheet(CLI::App& scene, const std::vector<std::string>& scenes,
                     const SceneFinder& find_scene, const std::stop_token& stop);

}  // namespace foveola
