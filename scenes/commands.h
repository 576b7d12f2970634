// The scenes' part of the command line: scene list and scene fetch.
#pragma once

#include <stop_token>

#include "renderer/command_line/cli_fwd.h"

namespace foveola::scenes {

/// Adds `scene list` and `scene fetch` to `app`; see add_render. Returns the
/// command `scene`, for modules that have more to say of one.
CLI::App& add_scene_commands(CLI::App& app, std::stop_token stop);

}  // namespace foveola::scenes
