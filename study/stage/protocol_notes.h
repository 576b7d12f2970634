// What the commands that begin a study say of its protocol before anybody takes part.
#pragma once

#include "study/protocol/protocol.h"

namespace foveola::study {

/// Says on standard error, a line for each, which keys are now called otherwise.
void print_notes(const Protocol& protocol);

}  // namespace foveola::study
