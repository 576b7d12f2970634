// Simulated participants' answers: ratings and questionnaires, and which measures they can judge.
#pragma once

#include <optional>
#include <vector>

#include "renderer/base/random.h"
#include "study/participant/participant.h"
#include "study/participant/population.h"
#include "study/protocol/protocol.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Draws an answer to each question that needs one, within its range. "age" is normal with the
/// background's mean and deviation; other numbers and points of a scale are normal with its mean
/// and deviation as fractions of their range. A choice is any option with equal probability, but
/// for "gender" only the first or the second, as published codings have it. Answers in words are
/// always the same, and are given only where they are required.
std::vector<Answer> draw_answers(const std::vector<Question>& questions,
                                 const Background& background, Pcg32& random);

/// Whether the protocol says by which judgement simulated participants answer the rating.
bool is_judged(const Question& rating);

/// The answer to a judged rating: that of artifacts, or of quality, which is the same judgement on
/// the reversed scale. `noticed_jnd` as below.
double rate(const RatingHabits& habits, const Question& scale, double noticed_jnd);

/// The point of `scale` by ordinal thresholds: the lowest below second_point_jnd, the next from
/// there on, and one more with each step_factor. `noticed_jnd`, at least 0, is the difference that
/// this person noticed.
double rate_artifacts(const RatingHabits& habits, const Question& scale, double noticed_jnd);

/// The task that leads to this mark; empty if simulated participants have no judgement for it.
std::optional<Task> judgement_of(const MarkEntry& mark);

/// Throws Error with file:line:column for a mark without a judgement, and for a rating other than
/// `artifacts` and answers in words: simulated values of it would mean nothing. Participants whose
/// times are drawn (see InjectedEffect) need no judgement.
void require_judgements(const Protocol& protocol);

}  // namespace foveola::study
