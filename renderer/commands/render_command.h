// The command `render`: from its arguments to an image file and a report, or to one path again.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

void add_render(CLI::App& app, const SceneFinder& find_scene, const std::stop_token& stop);

}  // namespace foveola
