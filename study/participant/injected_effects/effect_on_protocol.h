// Checks that an injected effect can be drawn for a protocol's marks, ratings and methods.
#pragma once

#include "study/participant/injected_effects/injected_effect.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Throws UsageError if an effect names a method, a mark or a rating that the protocol lacks, or
/// shifts a rating without numbers or by its whole scale. Also if it would bring a mark before
/// twice the time of the previous mark.
void require_drawable(const InjectedEffect& effect, const Protocol& protocol);

}  // namespace foveola::study
