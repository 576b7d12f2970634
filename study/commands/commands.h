// Adds the study's commands to the command line: see foveola study --help.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include <CLI/CLI.hpp>

#include "renderer/base/scene_source.h"
#include "renderer/command_line/cli_fwd.h"

namespace foveola::study {

/// Reports a finished simulated study, by code that this module must not know.
struct SimulationReporter {
  /// Throws Error if `folder` cannot be written to.
  std::function<void(const std::filesystem::path& folder)> check;
  /// Returns lines for the terminal. Throws Error.
  std::function<std::string(const std::filesystem::path& database,
                            const std::filesystem::path& folder)>
      write;
};

void add_simulate(CLI::App& study, const SceneFinderBeside& find_scene,
                  const SimulationReporter& reporter, const std::stop_token& stop);

/// Adds `study` and its commands to `app`; see add_render.
void add_study_commands(CLI::App& app, const SceneFinderBeside& find_scene,
                        const SimulationReporter& reporter, std::stop_token stop);

void add_check(CLI::App& study, const SceneFinderBeside& find_scene);
void add_plan(CLI::App& study);
void add_keys(CLI::App& study);

void add_status(CLI::App& study);
void add_summary(CLI::App& study);
void add_gaze(CLI::App& study);
void add_verify(CLI::App& study);
void add_backup(CLI::App& study);
void add_restore(CLI::App& study);
void add_merge(CLI::App& study);
void add_forget(CLI::App& study);

void add_replay(CLI::App& study, const SceneFinderBeside& find_scene, const std::stop_token& stop);

/// Adds `run`. It runs in the thread that parses the command line, the program's first.
void add_run(CLI::App& study, const SceneFinderBeside& find_scene, const std::stop_token& stop);

void add_watch(CLI::App& study, const std::stop_token& stop);

/// Adds `prediction` to the command `bench`.
void add_bench_prediction(CLI::App& bench, const SceneFinderBeside& find_scene,
                          std::stop_token stop);

/// Adds `sensitivity` to the command `bench`.
void add_bench_sensitivity(CLI::App& bench, const SceneFinderBeside& find_scene,
                           std::stop_token stop);

}  // namespace foveola::study
