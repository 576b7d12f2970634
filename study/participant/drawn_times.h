// Times of marks that are drawn from a model, with known ratios between methods.
#pragma once

#include <cstddef>
#include <string>

#include "study/participant/drawn_trial.h"
#include "study/participant/injected_effect.h"

namespace foveola::study {

/// The natural logarithm of a time is a sum of independent normal effects of the participant, of
/// the scene and of the trial, and of the injected effects. Medians and standard deviations are
/// assumed; recovering an injected effect does not depend on them.
struct TimesModel {
  double first_mark_s = 2.0;  ///< Median time of a trial's first mark after its first frame.
  double mark_ratio = 4.0;    ///< Ratio of each next mark's time to the one before.
  // Standard deviations of the natural logarithm.
  double participant_spread = 0.3;
  double scene_spread = 0.4;
  double trial_spread = 0.25;
};

/// One of the protocol's marks.
struct DrawnMark {
  std::size_t index = 0;  ///< Among the marks of a trial, in their order.
  std::string id;
};

/// The time of a mark after the trial's first frame, in seconds. It depends on its arguments alone,
/// and the scene's effect on its name alone. Between two methods' trials the logarithm of the ratio
/// of a mark's times is normal with mean -ln(factor_a / factor_b), where a method's factor is the
/// product of its own and the mark's with it, plus ln(order_factor) for each trial between them,
/// and standard deviation sqrt(2) trial_spread.
double drawn_time_s(const TimesModel& model, const InjectedEffect& effect, const DrawnTrial& trial,
                    const DrawnMark& mark);

}  // namespace foveola::study
