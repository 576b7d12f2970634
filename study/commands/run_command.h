// foveola study run.
#pragma once

#include <stop_token>

#include <CLI/CLI.hpp>

#include "renderer/base/scene_source.h"

namespace foveola::study {

/// It runs in the thread that parses the command line, the program's first.
void add_run(CLI::App& study, const SceneFinderBeside& find_scene, const std::stop_token& stop);

}  // namespace foveola::study
