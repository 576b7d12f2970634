#include "renderer/commands/bench/bench_commands.h"

#include <CLI/CLI.hpp>

namespace foveola {

CLI::App& add_bench_commands(CLI::App& app, const std::vector<std::string>& scenes,
                             const SceneFinder& find_scene, const std::stop_token& stop) {
  CLI::App* bench = app.add_subcommand(
      "bench", "Measure how fast and how exact the renderer and the statistics are");
  bench->require_subcommand(1);
  add_bench_stability(*bench, scenes, find_scene, stop);
  add_bench_sampling(*bench);
  add_bench_tracing(*bench, find_scene, stop);
  add_bench_preview(*bench, find_scene, stop);
  return *bench;
}

}  // namespace foveola
