#include "analysis/monte_carlo/gain_study.h"

#include <cmath>
#include <limits>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/participant_values.h"
#include "analysis/statistics/descriptive.h"
#include "analysis/statistics/normal.h"

namespace foveola::analysis {
namespace {

constexpr std::size_t only_mark = 0;

/// example_study with the baseline and one method, one mark, and no rating.
ExpectedStudy two_methods() {
  ExpectedStudy expected = example_study();
  expected.protocol.methods = {"od", "fv"};
  expected.protocol.marks.resize(1);
  expected.protocol.ratings.clear();
  expected.times = {{.baseline_s = 30.0, .ratios = {1.0, 0.5}}};
  expected.shifts.clear();
  return expected;
}

/// Of the logarithm of one time.
double log_time_variance(const ExpectedSpread& spread) {
  const auto square = [](double x) { return x * x; };
  return square(spread.participants) + square(spread.scenes) + square(spread.trials) +
         0.5 * (square(spread.participants_gain) + square(spread.scenes_gain));
}

}  // namespace

ExpectedStudy gain_study(const GainDesign& design) {
  ExpectedStudy expected = two_methods();
  expected.times_spread = {.participants = 0.5,
                           .scenes = 0.5,
                           .participants_gain = design.participants_gain,
                           .scenes_gain = design.scenes_gain,
                           .trials = 0.3};
  expected.protocol.analysis.primary = {{"outline", "fv", "od"}};
  expected.protocol.analysis.scenes = design.scenes;
  expected.times[only_mark].ratios.back() = design.ratio;
  if (design.margin) {
    expected.protocol.analysis.equivalence_margins = {{"outline", *design.margin}};
  }
  if (design.censored > 0.0) {
    expected.protocol.timing.mark_timeout_s =
        expected.times[only_mark].baseline_s *
        std::exp(normal_quantile(1.0 - design.censored) *
                 std::sqrt(log_time_variance(expected.times_spread)));
  }
  return expected;
}

ExpectedStudy rating_study() {
  ExpectedStudy expected = two_methods();
  expected.protocol.ratings = {example_study().protocol.ratings.front()};
  expected.shifts = {{0.0, 0.0}};
  expected.ratings_spread = ExpectedStudy().ratings_spread;
  expected.protocol.analysis.primary = {{"artifacts", "fv", "od"}};
  return expected;
}

double log_ratio_in_drawn_scenes(const ExpectedStudy& expected, std::uint64_t seed) {
  // Scenes are drawn before participants, and do not depend on them.
  ExpectedStudy scenes_alone = expected;
  scenes_alone.protocol.timing.mark_timeout_s = std::numeric_limits<double>::infinity();
  scenes_alone.times_spread.participants = 0.0;
  scenes_alone.times_spread.participants_gain = 0.0;
  scenes_alone.times_spread.trials = 0.0;
  const Dataset set = select_for_analysis(draw_study(scenes_alone, 1, seed));
  return paired_differences(participant_means(set, only_mark), 1, 0).front();
}

}  // namespace foveola::analysis
