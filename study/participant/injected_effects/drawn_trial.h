// Draws times and ratings of trials from a model with known differences between methods.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "study/participant/injected_effects/injected_effect.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

struct DrawnTrial {
  std::uint64_t seed = 0;  ///< The participant's seed.
  int participant = 1;     ///< Number of the participant; the first is 1.
  std::string scene;
  std::string method;
  int trials_before = 0;
  std::uint32_t timing = 0;  ///< Number of the attempt; each has a new effect of the trial.
};

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

/// Returns the time of a mark after the trial's first frame, in seconds. It depends on its
/// arguments alone, and the scene's effect on its name alone. Between two methods' trials, the
/// logarithm of the ratio of a mark's times is normal with standard deviation sqrt(2) trial_spread.
/// Its mean is -ln(factor_a / factor_b), plus ln(order_factor) for each trial between them. A
/// method's factor is the product of its own and the mark's with it.
double drawn_time_s(const TimesModel& model, const InjectedEffect& effect, const DrawnTrial& trial,
                    const DrawnMark& mark);

/// Returns the range of the shifts of a rating's answers; a method without a shift has 0.
Span span_of(const InjectedEffect::ByMethod& shifts);

/// Draws the answer to a rating that the effect shifts. The answer is centred in the scale less the
/// shifts' span. Independent effects of the participant and of the trial, both with triangular
/// distributions, move it by at most a quarter of that range each, so that no answer is clipped. It
/// is then rounded up or down to an answer of the scale, by chance, with unchanged expectation. The
/// expected difference of two methods is thus that of their shifts, on any scale. The answer
/// depends on the arguments alone. `rating` is numeric, and its range wider than the shifts' span.
double drawn_rating(const InjectedEffect& effect, const Question& rating, const DrawnTrial& trial);

}  // namespace foveola::study
