// foveola study status and gaze: what a study's file holds.
#pragma once

#include <CLI/CLI.hpp>

namespace foveola::study {

void add_status(CLI::App& study);
void add_gaze(CLI::App& study);

}  // namespace foveola::study
