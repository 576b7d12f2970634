// What simulated participants know how to judge of all that a protocol may ask in a trial.
#pragma once

#include <optional>

#include "study/participant/participant.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// What they look for until they make this mark; nothing if no judgement of theirs is behind it.
std::optional<Task> judgement_of(const MarkEntry& mark);

/// Throws Error with file:line:column for a mark without a judgement, and for a rating but
/// `artifacts` and words: what participants who look gave for it would be made up. Those whose
/// times are drawn (see InjectedEffect) need no judgement.
void require_judgements(const Protocol& protocol);

}  // namespace foveola::study
