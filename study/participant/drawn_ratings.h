// Ratings that are drawn from a model, with known differences between methods.
#pragma once

#include "study/participant/drawn_trial.h"
#include "study/participant/injected_effect.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// The shifts of a rating's answers, of which a method without one has 0.
Span span_of(const InjectedEffect::ByMethod& shifts);

/// Draws the answer to a rating that the effect shifts. Around the middle of what the shifts leave
/// of the scale, an independent effect of the participant and one of the trial, both with a
/// triangular distribution, move it by at most a quarter of that each, so that no answer has to be
/// cut off at an end; it is then rounded up or down to an answer that the scale has, by chance,
/// such that its expectation stays. So the expected difference between two methods is that of their
/// shifts, on any scale. The answer depends on the arguments alone. `rating` is numeric, and its
/// span wider than that of the shifts.
double drawn_rating(const InjectedEffect& effect, const Question& rating, const DrawnTrial& trial);

}  // namespace foveola::study
