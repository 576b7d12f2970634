// `foveola bench preview`: whether frames are in time on this machine, and where their time goes.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Adds `preview` to the command `bench`.
void add_bench_preview(CLI::App& bench, const SceneFinder& find_scene, const std::stop_token& stop);

}  // namespace foveola
