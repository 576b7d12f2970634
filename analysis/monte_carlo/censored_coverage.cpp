#include "analysis/monte_carlo/censored_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

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

std::vector<CoverageFigure> censored_figures() {
  std::vector<CoverageFigure> figures;
  for (const CrossedDesign& design : crossed_designs()) {
    for (const double censored : censored_shares) {
      for (const study::SceneEffects effect : effects) {
        figures.push_back(
            {.name = fmt::format("without R, scenes {}, {:.0f} % censored, {}", name_of(effect),
                                 100.0 * censored, design_in_words(design)),
             .claim = "covers in other scenes, too",
             .estimates_ratios = true});
      }
    }
  }
  return figures;
}

StudyCounts count_censored_coverage(const CoverageSettings& settings, const ItemRange& studies,
                                    const std::function<void(double)>& on_progress,
                                    const std::stop_token& stop) {
  constexpr std::size_t studies_at_once = 50;
  const std::vector<CrossedDesign> designs = crossed_designs();
  const Workers workers(settings.threads);
  StudyCounts counts;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    for (const double censored : censored_shares) {
      if (stop.stop_requested()) {
        return {};
      }
      const auto count_block = [&](std::size_t first, std::size_t last) {
        return count_stand_ins(designs[i], censored, settings.seed, first, last);
      };
      std::ranges::move(
          sum_of_blocks(effects.size(), studies, studies_at_once, workers, count_block),
          std::back_inserter(counts));
    }
    on_progress(static_cast<double>(i + 1) / static_cast<double>(designs.size()));
  }
  return counts;
}

}  // namespace foveola::analysis
