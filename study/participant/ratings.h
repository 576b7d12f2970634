// Simulated participants' ratings of artifacts.
#pragma once

#include "study/participant/population.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Whether the rating is that of artifacts, which simulated participants can judge.
bool is_judged(const Question& rating);

/// The point of `scale` by ordinal thresholds: the lowest below second_point_jnd, the next from
/// there on, and one more with each step_factor. `noticed_jnd`, at least 0, is the difference that
/// this person noticed.
double rate_artifacts(const RatingHabits& habits, const Question& scale, double noticed_jnd);

}  // namespace foveola::study
