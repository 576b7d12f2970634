// `foveola bench stability`: stress tests of the renderer's numbers.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Adds `stability` to the command `bench`, over `scenes`. It throws Error where a figure is not
/// met; `stop` ends it with the figures there are.
void add_bench_stability(CLI::App& bench, const std::vector<std::string>& scenes,
                         const SceneFinder& find_scene, const std::stop_token& stop);

}  // namespace foveola
