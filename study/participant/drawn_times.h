// Times of marks that nobody made: drawn, with ratios between methods that are known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "study/participant/injected_effect.h"

namespace foveola::study {

/// The natural logarithm of a time is a sum of independent normal parts, of the participant, of the
/// scene and of the participant's one trial, and of what is injected. Medians and deviations are
/// assumed; nothing that an injected effect is recovered for depends on the first three.
struct TimesModel {
  double first_mark_s = 2.0;  ///< median of a trial's first mark after its first frame
  double mark_ratio = 4.0;    ///< each next mark's time over that of the one before, in any trial
  double participant_spread = 0.3;
  double scene_spread = 0.4;
  double trial_spread = 0.25;
};

/// A trial of a participant.
struct DrawnTrial {
  std::uint64_t seed = 0;  ///< the participant's
  int participant = 1;     ///< the first is 1
  std::string scene;
  std::string method;
  int trials_before = 0;
  std::uint32_t timing = 0;  ///< another number gives another part of the trial
};

/// The time of a mark (0: the first) after the trial's first frame, in seconds. A function of its
/// arguments; the scene's part depends on its name alone. Between two methods' trials the logarithm
/// of the ratio is normal with mean -ln(faster_a / faster_b), plus ln(order_factor) for each trial
/// between them, and standard deviation sqrt(2) trial_spread.
double drawn_time_s(const TimesModel& model, const InjectedEffect& effect, const DrawnTrial& trial,
                    std::size_t mark);

}  // namespace foveola::study
