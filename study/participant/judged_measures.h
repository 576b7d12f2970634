// The measures of a protocol that simulated participants can judge.
#pragma once

#include <optional>

#include "study/participant/participant.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// The task that leads to this mark; empty if simulated participants have no judgement for it.
std::optional<Task> judgement_of(const MarkEntry& mark);

/// Throws Error with file:line:column for a mark without a judgement, and for a rating other than
/// `artifacts` and answers in words: simulated values of it would mean nothing. Participants whose
/// times are drawn (see InjectedEffect) need no judgement.
void require_judgements(const Protocol& protocol);

}  // namespace foveola::study
