// --headset, for the commands that show live pictures.
#pragma once

#include <string>

#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// Sets what --display and --tracker are given as, the latter where it is not given; both must
/// outlive the command.
void add_headset_option(CLI::App& command, std::string& display, std::string& tracker);

}  // namespace foveola
