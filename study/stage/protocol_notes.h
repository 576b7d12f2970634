// Prints notes about the protocol when a study begins.
#pragma once

#include "study/protocol/protocol.h"

namespace foveola::study {

/// Prints a line per outdated key on standard error.
void print_notes(const Protocol& protocol);

}  // namespace foveola::study
