// `foveola render`: renders an image file with a report, or traces one path again.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

void add_render(CLI::App& app, const SceneFinder& find_scene, const std::stop_token& stop);

}  // namespace foveola
