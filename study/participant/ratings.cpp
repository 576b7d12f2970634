#include "study/participant/ratings.h"

namespace foveola::study {

bool is_judged(const Question& rating) {
  return !rating.simulated.empty() && rating.kind == QuestionKind::likert;
}

double rate(const RatingHabits& habits, const Question& scale, double noticed_jnd) {
  const double artifacts = rate_artifacts(habits, scale, noticed_jnd);
  return scale.simulated == "quality" ? scale.minimum + scale.maximum - artifacts : artifacts;
}

double rate_artifacts(const RatingHabits& habits, const Question& scale, double noticed_jnd) {
  double rating = scale.minimum;
  double threshold_jnd = habits.second_point_jnd;
  while (rating < scale.maximum && noticed_jnd >= threshold_jnd) {
    rating += 1.0;
    threshold_jnd *= habits.step_factor;
  }
  return rating;
}

}  // namespace foveola::study
