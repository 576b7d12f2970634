// `foveola tracker`: lists eye trackers, and watches what one delivers.
#pragma once

#include <stop_token>

namespace CLI {
class App;
}

namespace foveola {

/// Adds `tracker list` and `tracker watch` to `app`.
void add_tracker_commands(CLI::App& app, const std::stop_token& stop);

}  // namespace foveola
