// What simulated participants answer when they rate what they saw.
#pragma once

#include "study/participant/population.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Whether it is the scale of artifacts, which is rated by what was noticed.
bool is_judged(const Question& rating);

/// A point of `scale` by ordinal thresholds: its lowest below second_point_jnd, one more from there
/// on and from each step_factor as much. noticed_jnd: at least 0, as this person notices it.
double rate_artifacts(const RatingHabits& habits, const Question& scale, double noticed_jnd);

}  // namespace foveola::study
