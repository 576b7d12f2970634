// `foveola bench`: benchmarks and stress tests of the renderer.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// Adds `bench` with its commands over `scenes` to `app`. They print a table, or JSON, to standard
/// output, and throw Error for a figure out of bounds. `stop` ends them with the figures so far.
/// Returns `bench`, for the commands of other modules.
CLI::App& add_bench_commands(CLI::App& app, const std::vector<std::string>& scenes,
                             const SceneFinder& find_scene, const std::stop_token& stop);

/// Adds `preview` to the command `bench`.
void add_bench_preview(CLI::App& bench, const SceneFinder& find_scene, const std::stop_token& stop);

/// Adds `sampling` to the command `bench`; see add_bench_commands.
void add_bench_sampling(CLI::App& bench);

/// Adds `stability` to the command `bench`, over `scenes`. It throws Error for a figure out of
/// bounds; `stop` ends it with the figures so far.
void add_bench_stability(CLI::App& bench, const std::vector<std::string>& scenes,
                         const SceneFinder& find_scene, const std::stop_token& stop);

void add_bench_tracing(CLI::App& bench, const SceneFinder& find_scene, const std::stop_token& stop);

}  // namespace foveola
