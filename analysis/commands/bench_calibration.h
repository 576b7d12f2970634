// `foveola bench calibration`: how fast the simulated machine must be for OD to take as long as it
// did in the published study.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola::analysis {

/// Adds `calibration` to the command `bench`; see add_renderer_commands.
void add_bench_calibration(CLI::App& bench, const SceneFinderBeside& find_scene,
                           std::stop_token stop);

}  // namespace foveola::analysis
