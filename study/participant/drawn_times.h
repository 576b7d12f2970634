// Times of marks that are drawn from a model, with known ratios between methods.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

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

/// A trial of a participant.
struct DrawnTrial {
  std::uint64_t seed = 0;  ///< The participant's seed.
  int participant = 1;     ///< Number of the participant; the first is 1.
  std::string scene;
  std::string method;
  int trials_before = 0;
  std::uint32_t timing = 0;  ///< Number of the attempt; each draws a new effect of the trial.
};

/// The time of a mark (0: the first) after the trial's first frame, in seconds. It depends on its
/// arguments alone, and the scene's effect on its name alone. Between two methods' trials the
/// logarithm of the ratio is normal with mean -ln(faster_a / faster_b), plus ln(order_factor) for
/// each trial between them, and standard deviation sqrt(2) trial_spread.
double drawn_time_s(const TimesModel& model, const InjectedEffect& effect, const DrawnTrial& trial,
                    std::size_t mark);

}  // namespace foveola::study
