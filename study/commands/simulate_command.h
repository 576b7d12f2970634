// foveola study simulate.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include <CLI/CLI.hpp>

#include "renderer/base/scene_source.h"

namespace foveola::study {

/// What is made of a simulated study once it is finished: it needs what this module must not know.
struct SimulationReporter {
  /// Throws Error if `folder` could not be written to.
  std::function<void(const std::filesystem::path& folder)> check;
  /// Returns lines for the terminal, each ended by a line break. Throws Error.
  std::function<std::string(const std::filesystem::path& database,
                            const std::filesystem::path& folder)>
      write;
};

void add_simulate(CLI::App& study, const SceneFinderBeside& find_scene,
                  const SimulationReporter& reporter, const std::stop_token& stop);

}  // namespace foveola::study
