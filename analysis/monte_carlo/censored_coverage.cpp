#include "analysis/monte_carlo/censored_coverage.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analysis/dataset/comparisons.h"
#include "analysis/monte_carlo/crossed_coverage.h"
#include "analysis/monte_carlo/gain_study.h"
#include "analysis/monte_carlo/interval_count.h"
#include "renderer/base/parallel.h"

namespace foveola::analysis {
namespace {

constexpr std::array effects = {study::SceneEffects::random, study::SceneEffects::fixed};
constexpr std::array censored_shares = {0.13, 0.32};

/// By what the plan says of scenes.
using StandIns = std::array<IntervalCount, effects.size()>;

StandIns count_stand_ins(const CrossedDesign& design, double censored, std::uint64_t seed,
                         std::size_t first, std::size_t last) {
  const ExpectedStudy expected = gain_study({.participants_gain = design.participant_sd,
                                             .scenes_gain = design.scene_sd,
                                             .censored = censored});
  StandIns counts;
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

StandIns count_stand_ins(const CrossedDesign& design, double censored,
                         const CoverageSettings& settings, const Workers& workers) {
  constexpr std::size_t studies_at_once = 50;
  const auto studies = static_cast<std::size_t>(settings.studies);
  std::vector<StandIns> parts((studies + studies_at_once - 1) / studies_at_once);
  workers.for_each_block(studies, studies_at_once, [&](std::size_t first, std::size_t last) {
    parts[first / studies_at_once] = count_stand_ins(design, censored, settings.seed, first, last);
  });
  StandIns all;
  for (const StandIns& part : parts) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].add(part[i]);
    }
  }
  return all;
}

}  // namespace

std::vector<CoverageFigure> measure_censored_coverage(
    const CoverageSettings& settings, const std::function<void(double)>& on_progress,
    const std::stop_token& stop) {
  const std::vector<CrossedDesign> designs = crossed_designs();
  const Workers workers(settings.threads);
  std::vector<CoverageFigure> figures;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    for (const double censored : censored_shares) {
      if (stop.stop_requested()) {
        return {};
      }
      const StandIns counts = count_stand_ins(designs[i], censored, settings, workers);
      for (std::size_t effect = 0; effect < effects.size(); ++effect) {
        figures.push_back(coverage_figure(
            fmt::format("without R, scenes {}, {:.0f} % censored, {}", name_of(effects[effect]),
                        100.0 * censored, design_in_words(designs[i])),
            "covers in other scenes, too", counts[effect].studies, counts[effect].covered));
        if (counts[effect].studies > 0) {
          figures.back().mean_ratio = counts[effect].mean_ratio();
        }
      }
    }
    on_progress(static_cast<double>(i + 1) / static_cast<double>(designs.size()));
  }
  return figures;
}

}  // namespace foveola::analysis
