// The command `foveola analyze`.
#pragma once

#include <stop_token>

namespace CLI {
class App;
}

namespace foveola::analysis {

/// Adds `analyze` to `app`; see add_renderer_commands.
void add_analysis_commands(CLI::App& app, std::stop_token stop);

}  // namespace foveola::analysis
