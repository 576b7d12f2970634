// The experimenter's console on standard input and output, of the kind that these are good for.
#pragma once

#include <memory>

#include "study/console/console.h"
#include "study/console/line_writer.h"

namespace foveola::study {

/// output: for standard output; must outlive it. is_json: for machines. Otherwise a screen, if both
/// are a terminal that can be painted on, or else lines, the first of which says how to ask for
/// what can be typed.
std::unique_ptr<Console> open_console(bool is_json, LineWriter& output);

/// One that takes no commands, for what is said before there is a session and after it: lines, or
/// JSON.
std::unique_ptr<Console> open_output(bool is_json, LineWriter& output);

}  // namespace foveola::study
