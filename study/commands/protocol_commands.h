// foveola study check and plan: what a protocol means, before anybody takes part.
#pragma once

#include <CLI/CLI.hpp>

#include "renderer/base/scene_source.h"

namespace foveola::study {

void add_check(CLI::App& study, const SceneFinderBeside& find_scene);
void add_plan(CLI::App& study);

}  // namespace foveola::study
