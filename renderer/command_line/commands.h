// The commands that print what the command line says of itself: manual and completion.
#pragma once

#include "renderer/command_line/cli_fwd.h"
#include "renderer/command_line/manual_page.h"

namespace foveola {

/// Adds `manual` and `completion` to `app`. They print to standard output, and describe `app` as it
/// is when they run. text: what the manual says beside.
void add_command_line_commands(CLI::App& app, const ManualText& text);

}  // namespace foveola
