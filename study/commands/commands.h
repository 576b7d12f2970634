// The study's part of the command line: see foveola study --help.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"
#include "study/commands/simulate_command.h"

namespace CLI {
class App;
}

namespace foveola::study {

/// Adds `study` and its commands to `app`; see add_renderer_commands.
void add_study_commands(CLI::App& app, const SceneFinderBeside& find_scene,
                        const SimulationReporter& reporter, std::stop_token stop);

}  // namespace foveola::study
