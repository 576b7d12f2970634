// `foveola bench convergence`: run time against error, method against method.
#pragma once

#include <filesystem>
#include <stop_token>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/commands/bench_part.h"

namespace CLI {
class App;
}

namespace foveola::analysis {

/// Adds `convergence` to the command `bench`. When stopped it writes what was measured so far.
void add_bench_convergence(CLI::App& bench, const SceneFinder& find_scene,
                           const std::stop_token& stop);

/// Writes of all parts of one `bench convergence` what it would have written without parts, but for
/// crops, which are of one machine, and with the times and names of the parts' machines. Throws
/// Error for parts that do not fit together and for a folder that cannot be written.
void merge_convergence(const std::vector<BenchPart>& parts, const std::filesystem::path& folder,
                       bool json);

}  // namespace foveola::analysis
