// The orders of a study, how even they are and how long a session takes, as plain aligned text.
#pragma once

#include <string>
#include <vector>

#include "study/design/balance.h"
#include "study/design/duration.h"
#include "study/design/plan.h"

namespace foveola::study {

/// One line for each participant and scene, in their order; practice on lines of its own, catch
/// trials in brackets.
std::string plan_table(const std::vector<Plan>& plans);

/// How often each method and scene stands where and follows which, with the largest differences.
std::string balance_table(const Protocol& protocol, const Balance& balance);

/// How long a session takes, part by part, in minutes, with what was assumed.
std::string duration_table(const std::vector<SessionPart>& parts);

}  // namespace foveola::study
