// The commands that print the command line's description: manual and completion.
#pragma once

#include "renderer/command_line/cli_fwd.h"
#include "renderer/command_line/manual_page.h"

namespace foveola {

/// Adds `manual` and `completion` to `app`. They print to standard output, and describe `app` when
/// they run. text: the manual's further sections.
void add_command_line_commands(CLI::App& app, const ManualText& text);

}  // namespace foveola
