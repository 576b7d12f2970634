// Options that many commands have. Each writes to a value that must outlive the parsing, and that
// initially holds the default.
#pragma once

#include <string>

#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// SCENE, which is required.
void add_scene_option(CLI::App& command, std::string& scene);
/// --max-depth, at least 1.
void add_max_depth_option(CLI::App& command, int& max_depth);
/// --threads, 0 to 1024.
void add_threads_option(CLI::App& command, int& threads);
/// --json.
void add_json_option(CLI::App& command, bool& json);

}  // namespace foveola
