// `foveola bench stability`: stress tests of the renderer's numbers.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/commands/bench_part.h"

namespace CLI {
class App;
}

namespace foveola {

inline constexpr const char* stability_command = "stability";

/// Adds `stability` to the command `bench`, over `scenes`. It throws Error where a figure is not
/// met; `stop` ends it with the figures there are.
void add_bench_stability(CLI::App& bench, const std::vector<std::string>& scenes,
                         const SceneFinder& find_scene, const std::stop_token& stop);

/// Prints of all parts of one `bench stability --only finite` what it would have printed without
/// parts, but for the time, which is that of all parts together, and throws Error where it would
/// have.
void merge_stability(const std::vector<BenchPart>& parts, bool json);

}  // namespace foveola
