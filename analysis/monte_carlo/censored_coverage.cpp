#include "analysis/monte_carlo/censored_coverage.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analysis/dataset/comparisons.h"
#include "analysis/monte_carlo/crossed_coverage.h"
#include "analysis/monte_carlo/gain_study.h"
#include "renderer/base/parallel.h"

namespace foveola::analysis {
namespace {

constexpr std::array effects = {study::SceneEffects::random, study::SceneEffects::fixed};
constexpr std::array censored_shares = {0.13, 0.32};

/// By what the plan says of scenes.
StudyCounts count_stand_ins(const CrossedDesign& design, double censored, std::uint64_t seed,
                            std::size_t first, std::size_t last) {
  const ExpectedStudy expected = gain_study({.participants_gain = design.participant_sd,
                                             .scenes_gain = design.scene_sd,
                                             .censored = censored});
  StudyCounts counts(effects.size());
  for (std::size_t study = first; study < last; ++study) {
    const Dataset set =
        select_for_analysis(draw_study(expected, design.participants, (seed << 32U) + study));
    study::AnalysisPlan plan = expected.protocol.analysis;
    for (std::size_t i = 0; i < effects.size(); ++i) {
      plan.scenes = effects[i];
      const auto found = planned_primary_analyses(set, plan).front().primary;
      if (found && found->interval) {
        counts[i].add(*found, design.mean);
      }
    }
  }
  return counts;
}

}  // namespace

std::vector<CoverageFigure> measure_censored_coverage(
    const CoverageSettings& settings, const std::function<void(double)>& on_progress,
    const std::stop_token& stop) {
  constexpr std::size_t studies_at_once = 50;
  const std::vector<CrossedDesign> designs = crossed_designs();
  const Workers workers(settings.threads);
  std::vector<CoverageFigure> figures;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    for (const double censored : censored_shares) {
      if (stop.stop_requested()) {
        return {};
      }
      const auto count_block = [&](std::size_t first, std::size_t last) {
        return count_stand_ins(designs[i], censored, settings.seed, first, last);
      };
      const StudyCounts counts =
          sum_of_blocks(effects.size(), settings.studies, studies_at_once, workers, count_block);
      for (std::size_t effect = 0; effect < effects.size(); ++effect) {
        figures.push_back(
            measured({.name = fmt::format("without R, scenes {}, {:.0f} % censored, {}",
                                          name_of(effects[effect]), 100.0 * censored,
                                          design_in_words(designs[i])),
                      .claim = "covers in other scenes, too",
                      .estimates_ratios = true},
                     counts[effect]));
      }
    }
    on_progress(static_cast<double>(i + 1) / static_cast<double>(designs.size()));
  }
  return figures;
}

}  // namespace foveola::analysis
