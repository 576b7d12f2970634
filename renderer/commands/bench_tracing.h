// `foveola bench tracing`: what a path costs, beside what Embree alone takes for the same rays.
#pragma once

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

void add_bench_tracing(CLI::App& bench, const SceneFinder& find_scene);

}  // namespace foveola
