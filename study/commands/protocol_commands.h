// foveola study check, plan and keys: what a protocol means, before anybody takes part, and what
// one can say.
#pragma once

#include <CLI/CLI.hpp>

#include "renderer/base/scene_source.h"

namespace foveola::study {

void add_check(CLI::App& study, const SceneFinderBeside& find_scene);
void add_plan(CLI::App& study);
void add_keys(CLI::App& study);

}  // namespace foveola::study
