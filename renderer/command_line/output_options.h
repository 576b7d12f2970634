// Refuses outputs that are inputs: a command never overwrites a file that it reads.
#pragma once

#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// Marks an option as the path of an output of its command, as every --output is. Returns it.
CLI::Option* mark_output(CLI::Option* option);

/// Checks the given commands. Throws Error if an output is also another file on the command line,
/// under any name, or has the name of a file beside a study: its log, its lock, its backups. Other
/// inputs are refused when a command opens them: see guard_output().
void keep_outputs_apart(CLI::App& app);

}  // namespace foveola
