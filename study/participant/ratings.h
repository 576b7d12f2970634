// Simulated participants' ratings.
#pragma once

#include "study/participant/population.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Whether the protocol says by which judgement simulated participants answer the rating.
bool is_judged(const Question& rating);

/// The answer to a judged rating: that of artifacts, or of quality, which is the same judgement on
/// the reversed scale. `noticed_jnd` as below.
double rate(const RatingHabits& habits, const Question& scale, double noticed_jnd);

/// The point of `scale` by ordinal thresholds: the lowest below second_point_jnd, the next from
/// there on, and one more with each step_factor. `noticed_jnd`, at least 0, is the difference that
/// this person noticed.
double rate_artifacts(const RatingHabits& habits, const Question& scale, double noticed_jnd);

}  // namespace foveola::study
