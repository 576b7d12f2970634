// `foveola bench prediction`: predicted sessions against rendered ones of the same participants.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola::study {

/// Adds `prediction` to the command `bench`.
void add_bench_prediction(CLI::App& bench, const SceneFinderBeside& find_scene,
                          std::stop_token stop);

}  // namespace foveola::study
