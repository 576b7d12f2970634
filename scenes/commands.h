// The scenes' part of the command line: scene list, scene make.
#pragma once

#include <stop_token>

namespace CLI {
class App;
}

namespace foveola::scenes {

/// Adds `scene list` and `scene make` to `app`; see add_renderer_commands.
void add_scene_commands(CLI::App& app, std::stop_token stop);

}  // namespace foveola::scenes
