// foveola study status, summary, gaze, verify, backup, restore, merge and forget: what a study's
// file holds, and its care.
#pragma once

#include <CLI/CLI.hpp>

namespace foveola::study {

void add_status(CLI::App& study);
void add_summary(CLI::App& study);
void add_gaze(CLI::App& study);
void add_verify(CLI::App& study);
void add_backup(CLI::App& study);
void add_restore(CLI::App& study);
void add_merge(CLI::App& study);
void add_forget(CLI::App& study);

}  // namespace foveola::study
