// Adds the analysis's commands: `foveola analyze`, its benchmarks and the manual page's text.
#pragma once

#include <stop_token>
#include <string>

#include "analysis/publication/analyze_study.h"
#include "renderer/base/scene_source.h"
#include "renderer/command_line/cli_fwd.h"
#include "renderer/command_line/manual_page.h"

namespace foveola::analysis {

/// Adds `analyze` to `app`; see add_render.
void add_analysis_commands(CLI::App& app, std::stop_token stop);

/// Adds `calibration` to the command `bench`; see add_render.
void add_bench_calibration(CLI::App& bench, const SceneFinderBeside& find_scene,
                           std::stop_token stop);

/// Adds `compare` to the command `bench`.
void add_bench_compare(CLI::App& bench);

/// Adds `convergence` to the command `bench`. When stopped it writes the finished measurements.
void add_bench_convergence(CLI::App& bench, const SceneFinder& find_scene,
                           const std::stop_token& stop);

/// Adds `statistics` to the command `bench`. It throws Error if a figure lies outside its required
/// range; `stop` ends it without figures.
void add_bench_statistics(CLI::App& bench, const std::stop_token& stop);

/// Adds `replicate` to `app`; see add_renderer_commands. It throws Error if a claim does not hold.
void add_replicate(CLI::App& app, const std::stop_token& stop);

/// Returns the paths, the warnings and the main numbers as an indented JSON object. Missing values
/// are null; invalid UTF-8 in texts is replaced.
std::string analysis_json(const AnalysisOutput& output);

/// Returns description, exit status, environment, files and related programs.
ManualText manual_text();

}  // namespace foveola::analysis
