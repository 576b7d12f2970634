#include "analysis/monte_carlo/censored_coverage.h"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/dataset.h"
#include "analysis/dataset/participant_values.h"
#include "analysis/statistics/descriptive.h"
#include "analysis/statistics/distributions.h"
#include "renderer/base/work/parallel.h"

namespace foveola::analysis {
namespace {

constexpr std::size_t only_mark = 0;

/// Returns example_study with the baseline and one method, one mark, and no rating.
ExpectedStudy two_methods() {
  ExpectedStudy expected = example_study();
  expected.protocol.methods = {"od", "fv"};
  expected.protocol.marks.resize(1);
  expected.protocol.ratings.clear();
  expected.times = {{.baseline_s = 30.0, .ratios = {1.0, 0.5}}};
  expected.shifts.clear();
  return expected;
}

double log_time_variance(const ExpectedSpread& spread) {
  const auto square = [](double x) { return x * x; };
  return square(spread.participants) + square(spread.scenes) + square(spread.trials) +
         0.5 * (square(spread.participants_gain) + square(spread.scenes_gain));
}

constexpr Interval crossed_required = {93.5, 98.5};
constexpr const char* other_scenes = "covers in other scenes, too";

StudyCounts count(const CrossedDesign& design, std::uint64_t seed, std::size_t first,
                  std::size_t last) {
  const CrossedCoverage found = count_coverage(design, design.mean, seed, first, last);
  return {{.studies = found.studies, .hits = found.crossed_model},
          {.studies = found.studies, .hits = found.over_participants}};
}

constexpr std::array effects = {study::SceneEffects::random, study::SceneEffects::fixed};
constexpr std::array censored_shares = {0.13, 0.32};

/// Counts by the plan's scene effects.
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

std::vector<CrossedDesign> crossed_designs() {
  std::vector<CrossedDesign> all;
  for (const std::size_t participants : {12U, 16U, 24U, 40U}) {
    for (const double participant_sd : {0.0, 0.1, 0.2}) {
      for (const double scene_sd : {0.0, 0.1, 0.2}) {
        all.push_back({.participants = participants,
                       .mean = std::log(0.5),
                       .participant_sd = participant_sd,
                       .scene_sd = scene_sd});
      }
    }
  }
  return all;
}

std::string design_in_words(const CrossedDesign& design) {
  return fmt::format("{} × {}, SD {:g} people, {:g} scenes", design.participants, design.scenes,
                     design.participant_sd, design.scene_sd);
}

std::vector<CoverageFigure> measure_crossed_coverage(const CoverageSettings& settings,
                                                     const std::function<void(double)>& on_progress,
                                                     const std::stop_token& stop) {
  constexpr std::size_t analyses = 2;
  constexpr std::size_t studies_at_once = 200;
  const std::vector<CrossedDesign> designs = crossed_designs();
  const Workers workers(settings.threads);
  std::vector<CoverageFigure> figures;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    if (stop.stop_requested()) {
      return {};
    }
    const auto count_block = [&](std::size_t first, std::size_t last) {
      return count(designs[i], settings.seed, first, last);
    };
    const StudyCounts counts =
        sum_of_blocks(analyses, settings.studies, studies_at_once, workers, count_block);
    const std::string design = design_in_words(designs[i]);
    figures.push_back(measured({.name = fmt::format("crossed model, {}", design),
                                .claim = other_scenes,
                                .required = crossed_required},
                               counts.front()));
    figures.push_back(
        measured({.name = fmt::format("t over participants, {}", design), .claim = other_scenes},
                 counts.back()));
    on_progress(static_cast<double>(i + 1) / static_cast<double>(designs.size()));
  }
  return figures;
}

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
  // Scenes are drawn before participants, and independently of them.
  ExpectedStudy scenes_alone = expected;
  scenes_alone.protocol.timing.mark_timeout_s = std::numeric_limits<double>::infinity();
  scenes_alone.times_spread.participants = 0.0;
  scenes_alone.times_spread.participants_gain = 0.0;
  scenes_alone.times_spread.trials = 0.0;
  const Dataset set = select_for_analysis(draw_study(scenes_alone, 1, seed));
  return paired_differences(participant_means(set, only_mark), 1, 0).front();
}

}  // namespace foveola::analysis
