// What the commands that begin a study say of its analysis before anybody takes part.
#pragma once

#include "study/protocol/protocol.h"

namespace foveola::study {

/// Throws Error for the first thing that the protocol asks of the analysis and does not get; see
/// unanalysable().
void require_analysable(const Protocol& protocol);

/// The same things as warnings, for a study that was begun before they were refused: who took part
/// in it cannot do so again, and the rest of its participants are still to come.
void warn_of_unanalysable(const Protocol& protocol);

/// Says on standard error, a line for each, what comes out in the record only (see recorded_only())
/// and which keys are now called otherwise.
void warn_of_recorded_only(const Protocol& protocol);

}  // namespace foveola::study
