// foveola study replay.
#pragma once

#include <stop_token>

#include <CLI/CLI.hpp>

#include "renderer/base/scene_source.h"

namespace foveola::study {

void add_replay(CLI::App& study, const SceneFinderBeside& find_scene, const std::stop_token& stop);

}  // namespace foveola::study
