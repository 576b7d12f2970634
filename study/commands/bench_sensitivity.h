// `foveola bench sensitivity`: what moves the times of simulated participants.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola::study {

/// Adds `sensitivity` to the command `bench`.
void add_bench_sensitivity(CLI::App& bench, const SceneFinderBeside& find_scene,
                           std::stop_token stop);

}  // namespace foveola::study
