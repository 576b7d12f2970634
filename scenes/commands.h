// Adds the scenes' commands: scene list and scene fetch.
#pragma once

#include <stop_token>

// Not command_line/cli_fwd.h: this header is installed, that one is not.
namespace CLI {
class App;
}  // namespace CLI

namespace foveola::scenes {

/// Adds `scene list` and `scene fetch` to `app`; see add_render. Returns the command `scene`, to
/// which other modules add theirs.
CLI::App& add_scene_commands(CLI::App& app, std::stop_token stop);

}  // namespace foveola::scenes
