#include "analysis/monte_carlo/crossed_coverage.h"

#include <cmath>

#include <fmt/format.h>

#include "renderer/base/parallel.h"

namespace foveola::analysis {
namespace {

constexpr Interval crossed_required = {93.5, 98.5};
constexpr const char* other_scenes = "covers in other scenes, too";

StudyCounts count(const CrossedDesign& design, std::uint64_t seed, std::size_t first,
                  std::size_t last) {
  const CrossedCoverage found = count_coverage(design, design.mean, seed, first, last);
  return {{.studies = found.studies, .hits = found.crossed_model, .estimates = {}},
          {.studies = found.studies, .hits = found.over_participants, .estimates = {}}};
}

}  // namespace

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

}  // namespace foveola::analysis
