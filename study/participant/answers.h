// Simulates answers of participants: ratings and questionnaires.
#pragma once

#include <optional>
#include <vector>

#include "renderer/base/numbers/random.h"
#include "study/participant/participant.h"
#include "study/participant/population.h"
#include "study/protocol/protocol.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Draws an answer within its range to each question that needs one. "age" is normal with the
/// background's mean and deviation; other numbers and scale points are normal with its mean and
/// deviation as fractions of their range. A choice is any option with equal probability, but for
/// "gender" only the first or the second, as published codings have it. Free text is constant, and
/// given only where it is required.
std::vector<Answer> draw_answers(const std::vector<Question>& questions,
                                 const Background& background, Pcg32& random);

/// Returns whether the protocol names the judgement by which simulated participants answer the
/// rating.
bool is_judged(const Question& rating);

/// Returns the answer to a judged rating: of artifacts, or of quality, the same judgement on the
/// reversed scale. `noticed_jnd` as below.
double rate(const RatingHabits& habits, const Question& scale, double noticed_jnd);

/// Returns the point of `scale` by ordinal thresholds: the lowest below second_point_jnd, the next
/// from there on, and one more with each step_factor. `noticed_jnd`, at least 0: the difference
/// that this person noticed.
double rate_artifacts(const RatingHabits& habits, const Question& scale, double noticed_jnd);

/// Returns the task that leads to this mark; empty if simulated participants have no judgement for
/// it.
std::optional<Task> judgement_of(const MarkEntry& mark);

/// Throws Error with file:line:column for a mark without a judgement, and for a rating that is
/// neither `artifacts` nor free text: its simulated values would mean nothing. Participants with
/// drawn times (see InjectedEffect) need no judgement.
void require_judgements(const Protocol& protocol);

}  // namespace foveola::study
