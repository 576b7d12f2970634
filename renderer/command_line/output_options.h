// No output is an input: what a command writes takes the place of nothing that it reads.
#pragma once

#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// Marks an option as the path of something that its command writes, as every --output is. Returns
/// it.
CLI::Option* mark_output(CLI::Option* option);

/// Of the commands that were given. Throws Error if an output is a file that the command line
/// names, too, by whatever name, or by its own name one of the files that a study has beside it:
/// its log, its lock, its backups. What commands read beside what the command line names is refused
/// when they open it: see guard_output().
void keep_outputs_apart(CLI::App& app);

}  // namespace foveola
