// `foveola preview`: the live window.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Adds `preview` to `app`. It runs in the thread that parses the command line, the program's
/// first, until its window is closed or `stop` is requested.
void add_preview(CLI::App& app, const SceneFinder& find_scene, const std::stop_token& stop);

}  // namespace foveola
