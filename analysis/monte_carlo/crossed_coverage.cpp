#include "analysis/monte_carlo/crossed_coverage.h"

#include <cmath>

#include <fmt/format.h>

#include "renderer/base/parallel.h"

namespace foveola::analysis {
namespace {

constexpr Interval crossed_required = {93.5, 98.5};
constexpr const char* other_scenes = "covers in other scenes, too";

CrossedCoverage count(const CrossedDesign& design, const CoverageSettings& settings,
                      const Workers& workers) {
  constexpr std::size_t block = 200;
  const auto studies = static_cast<std::size_t>(settings.studies);
  std::vector<CrossedCoverage> parts((studies + block - 1) / block);
  workers.for_each_block(studies, block, [&](std::size_t first, std::size_t last) {
    parts[first / block] = count_coverage(design, design.mean, settings.seed, first, last);
  });
  CrossedCoverage all;
  for (const CrossedCoverage& part : parts) {
    all.studies += part.studies;
    all.crossed_model += part.crossed_model;
    all.over_participants += part.over_participants;
  }
  return all;
}

std::string named(const std::string& analysis, const CrossedDesign& design) {
  return fmt::format("{}, {}", analysis, design_in_words(design));
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
  const std::vector<CrossedDesign> all = crossed_designs();
  const Workers workers(settings.threads);
  std::vector<CoverageFigure> figures;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (stop.stop_requested()) {
      return {};
    }
    const CrossedCoverage found = count(all[i], settings, workers);
    figures.push_back(coverage_figure(named("crossed model", all[i]), other_scenes, found.studies,
                                      found.crossed_model));
    figures.back().required = crossed_required;
    figures.push_back(coverage_figure(named("t over participants", all[i]), other_scenes,
                                      found.studies, found.over_participants));
    on_progress(static_cast<double>(i + 1) / static_cast<double>(all.size()));
  }
  return figures;
}

}  // namespace foveola::analysis
