// Options and helpers that the `study` commands share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>

#include <CLI/CLI.hpp>

#include "renderer/base/scene_source.h"
#include "renderer/command_line/common_options.h"
#include "study/simulation/simulate_study.h"

namespace foveola::study {

inline constexpr int most_participants = 100'000;
inline constexpr int max_jobs = 1024;

/// Adds a subcommand of `study` or `bench`. example: without the program and the parent, "check
/// demo".
CLI::App* add_command(CLI::App& parent, const std::string& name, const std::string& purpose,
                      const std::string& example);

/// Arguments of the benchmarks that simulate studies.
struct SimulatedBenchArguments {
  SimulateSettings simulation{.resume = true};  ///< all but the files
  std::string protocol;
  std::string folder;
  bool json = false;
};

/// Simulates the study into this file, and resumes a study begun there.
SimulateReport simulate_study(const SimulatedBenchArguments& arguments,
                              const std::filesystem::path& database,
                              const SceneFinderBeside& find_scene, const std::stop_token& stop);

// Options of several commands; the targets must outlive the command's parsing.
void add_protocol(CLI::App* command, std::string& protocol);
void add_database(CLI::App* command, std::string& database);  ///< the file of a study that exists
void add_participants_and_seed(CLI::App* command, int& participants, std::uint64_t& seed);
/// Adds PROTOCOL, the folder, the participants and the seed.
void add_simulated_studies(CLI::App* command, SimulatedBenchArguments& arguments,
                           const std::string& folder_help);
/// Adds --threads, --jobs and --json.
void add_effort_and_json(CLI::App* command, SimulatedBenchArguments& arguments);

/// Throws Error unless the folder can hold a copy of the study. Warns if it is on the study's own
/// disk.
void require_backup_target(const std::filesystem::path& folder, const std::filesystem::path& study);

}  // namespace foveola::study
