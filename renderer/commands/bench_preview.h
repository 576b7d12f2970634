// `foveola bench preview`: whether frames are in time on this machine, where their time goes, and
// how long it takes from the eye's movement to light.
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
