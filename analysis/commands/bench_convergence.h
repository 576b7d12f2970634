// `foveola bench convergence`: run time against error, method against method.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola::analysis {

/// Adds `convergence` to the command `bench`. When stopped it writes what was measured so far.
void add_bench_convergence(CLI::App& bench, const SceneFinder& find_scene,
                           const std::stop_token& stop);

}  // namespace foveola::analysis
