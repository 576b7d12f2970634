// What the manual page says of the program as a whole, beside its command line.
#pragma once

#include "renderer/command_line/manual_page.h"

namespace foveola::analysis {

/// Description, exit status, environment, files and related programs.
ManualText manual_text();

}  // namespace foveola::analysis
