// The renderer's part of the command line: render and compare.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Adds `render` and `compare` to `app`. They run when the command line is parsed, print
/// their result to standard output and throw Error for whatever the user can mend. Work ends early,
/// with what there is, when `stop` is requested.
void add_renderer_commands(CLI::App& app, const SceneFinder& find_scene, std::stop_token stop);

}  // namespace foveola
