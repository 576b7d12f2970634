#include "analysis/statistics/models/crossed_study.h"

#include <cassert>
#include <cmath>
#include <vector>

#include "analysis/statistics/models/crossed_model.h"
#include "analysis/statistics/paired_t.h"

namespace foveola::analysis {
namespace {

bool covers(const Interval& interval, double value) {
  return interval.low <= value && value <= interval.high;
}

std::vector<double> participant_means(const RepeatedMeasures& data) {
  std::vector<double> means;
  means.reserve(data.participants);
  for (std::size_t participant = 0; participant < data.participants; ++participant) {
    means.push_back(static_cast<double>(extended_mean(data.of(participant))));
  }
  return means;
}

}  // namespace

RepeatedMeasures draw_log_ratios(const CrossedDesign& design, Pcg32& generator) {
  std::vector<double> scene_effects(design.scenes);
  for (double& effect : scene_effects) {
    effect = design.scene_sd * generator.normal();
  }
  const double residual_sd = std::sqrt(2.0) * design.residual_sd;
  RepeatedMeasures data{design.participants, design.scenes, {}};
  data.values.reserve(design.participants * design.scenes);
  for (std::size_t participant = 0; participant < design.participants; ++participant) {
    const double gain = design.mean + design.participant_sd * generator.normal();
    for (const double scene_effect : scene_effects) {
      data.values.push_back(gain + scene_effect + residual_sd * generator.normal());
    }
  }
  return data;
}

CrossedCoverage count_coverage(const CrossedDesign& design, double value, std::uint64_t seed,
                               std::uint64_t first, std::uint64_t last, double confidence) {
  assert(design.participants >= 2 && design.scenes >= 2 && design.residual_sd > 0.0);
  CrossedCoverage counts;
  for (std::uint64_t study = first; study < last; ++study) {
    Pcg32 generator(seed, study);
    const RepeatedMeasures data = draw_log_ratios(design, generator);
    const std::optional<CrossedModel> model = crossed_model(data, confidence);
    const std::optional<RatioTest> over_participants =
        test_ratio(participant_means(data), confidence);
    ++counts.studies;
    counts.crossed_model += covers(model->test.value().interval, value) ? 1 : 0;
    counts.over_participants += covers(over_participants.value().logs.interval, value) ? 1 : 0;
  }
  return counts;
}

}  // namespace foveola::analysis
