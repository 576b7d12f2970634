// The option --headset, for commands that show live pictures.
#pragma once

#include <string>

#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// Sets the values of --display and, unless given, of --tracker; both must outlive the command.
void add_headset_option(CLI::App& command, std::string& display, std::string& tracker);

}  // namespace foveola
