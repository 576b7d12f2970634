#include "analysis/monte_carlo/model_coverage.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/trial_data.h"
#include "analysis/monte_carlo/censored_coverage.h"
#include "analysis/r_models/fit_models.h"
#include "analysis/r_models/models_plan.h"
#include "analysis/r_models/models_script.h"
#include "analysis/tables/row_file.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/work/parallel.h"

namespace fs = std::filesystem;
namespace foveola::analysis {
namespace {

bool has_data(const study::StudyRecords& records) {
  return std::ranges::any_of(records.sessions,
                             [](const study::SessionRow& row) { return row.state == "completed"; });
}

void write_study(const study::StudyRecords& records, const fs::path& folder) {
  const Dataset set = select_for_analysis(records);
  const ColumnsOf<std::size_t> trials = trial_columns(records, set);
  RowFile file(folder / "trials_long.csv", columns_in(trials));
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    file.add(row_of(trials, i));
  }
  file.close();
  const study::AnalysisPlan& plan = records.protocol.analysis;
  write_file(folder / "models_plan.csv",
             csv_of(models_plan(set, planned_pairs(set, plan), plan.scenes, ModelDetail::p_only)));
}

constexpr Interval nominal_range = {93.5, 96.5};

ModelCell tobit_cell(std::size_t participants, const GainDesign& design) {
  const bool is_fixed = design.scenes == study::SceneEffects::fixed;
  return {
      .name = fmt::format("Tobit, {} people, {:.0f} % censored, SD {:g} people, {:g} scenes, {}",
                          participants, 100.0 * design.censored, design.participants_gain,
                          design.scenes_gain, is_fixed ? "fixed" : "random"),
      .expected = gain_study(design),
      .participants = participants};
}

ModelCell crossed_cell(std::size_t participants) {
  return {.name = fmt::format("crossed by lmer, {} people, 10 % of trials missing, SD 0.1 people, "
                              "0.1 scenes, random",
                              participants),
          .expected = gain_study({.participants_gain = 0.1, .scenes_gain = 0.1}),
          .participants = participants,
          .gaps = 0.1};
}

ModelCell equivalence_cell(double censored, double ratio) {
  constexpr std::size_t participants = 24;
  return {.name = fmt::format("equivalence within 25 %, {} people, {:.0f} % censored, ratio {:g}",
                              participants, 100.0 * censored, ratio),
          .expected = gain_study({.participants_gain = 0.15,
                                  .censored = censored,
                                  .scenes = study::SceneEffects::fixed,
                                  .ratio = ratio,
                                  .margin = 1.25}),
          .participants = participants};
}

ModelCell ordinal_cell(std::size_t participants) {
  return {.name = fmt::format("ordinal by clmm, {} people, no effect", participants),
          .expected = rating_study(),
          .participants = participants,
          .is_rating = true};
}

/// Ratings of 2 and 3 with the baseline, and of 3 and 4 with the method: the odds ratio is
/// infinite.
ModelCell separated_cell(std::size_t participants) {
  ModelCell cell = ordinal_cell(participants);
  cell.name = fmt::format("ordinal by clmm, {} people, separated ratings", participants);
  cell.expected.shifts = {{0.0, 1.0}};
  cell.expected.ratings_spread = {.participants = 0.0,
                                  .scenes = 0.0,
                                  .participants_gain = 0.0,
                                  .scenes_gain = 0.0,
                                  .trials = 0.06};
  return cell;
}

bool is_separated(const ModelCell& cell) {
  return cell.is_rating && cell.expected.shifts.front().back() != 0.0;
}

std::size_t study_count_of(const ModelCell& cell, const ModelCoverageSettings& settings) {
  if (is_separated(cell)) {
    return (settings.studies + 19) / 20;  // slowest in clmm
  }
  return cell.is_rating ? (2 * settings.studies + 4) / 5 : settings.studies;
}

void remove_values(double share, std::uint64_t seed, study::StudyRecords& records) {
  constexpr std::uint64_t stream = 1U << 20U;  // not used by participants
  Pcg32 generator(seed, stream);
  for (std::size_t row = 0; row < records.trials.size(); ++row) {
    if (generator.uniform() < share) {
      const auto first =
          records.values.begin() + static_cast<std::ptrdiff_t>(row * records.measures.size());
      std::fill_n(first, records.measures.size(), study::Value{});
    }
  }
}

std::uint64_t seed_of(const ModelCell& cell, const ModelCoverageSettings& settings,
                      std::size_t study) {
  return (settings.seed << 40U) + (cell.stream << 32U) + study;
}

study::StudyRecords draw(const ModelCell& cell, std::uint64_t seed) {
  study::StudyRecords records = draw_study(cell.expected, cell.participants, seed);
  remove_values(cell.gaps, seed, records);
  return records;
}

struct Truth {
  double in_these_scenes = 0.0;
  double in_all_scenes = 0.0;
};

Truth truth_of(const ModelCell& cell, std::uint64_t seed) {
  if (cell.is_rating) {
    return {};
  }
  return {.in_these_scenes = log_ratio_in_drawn_scenes(cell.expected, seed),
          .in_all_scenes = std::log(cell.expected.times.front().ratios.back())};
}

bool has_fixed_scenes(const ModelCell& cell) {
  return cell.expected.protocol.analysis.scenes == study::SceneEffects::fixed;
}

bool tests_equivalence(const ModelCell& cell) {
  return !cell.expected.protocol.analysis.equivalence_margins.empty();
}

std::vector<CoverageFigure> model_figures(const ModelCell& cell) {
  const bool is_fixed = has_fixed_scenes(cell);
  const auto figure = [&](const char* claim) -> CoverageFigure {
    return {.name = cell.name, .claim = claim, .estimates_ratios = !cell.is_rating};
  };
  if (is_separated(cell)) {
    std::vector<CoverageFigure> found = {figure("finds the difference"),
                                         figure("finds it without R")};
    found.front().required = Interval{99.0, 100.0};
    found.front().few_studies = true;
    return found;
  }
  if (tests_equivalence(cell)) {
    const bool is_equal = cell.expected.times.front().ratios.back() == 1.0;
    std::vector<CoverageFigure> declared = {figure(is_equal ? "declared" : "wrongly declared"),
                                            figure("declared without R")};
    for (CoverageFigure& of_tests : declared) {
      of_tests.estimates_ratios = false;
    }
    if (!is_equal) {
      declared.front().required = Interval{0.0, 6.8};
      declared.front().few_studies = true;
    }
    return declared;
  }
  std::vector<CoverageFigure> figures = {figure(cell.is_rating ? "covers no difference"
                                                : is_fixed     ? "covers in these scenes"
                                                               : "covers")};
  figures.front().required = nominal_range;
  figures.front().few_studies = true;
  if (is_fixed) {
    figures.push_back(figure("covers in other scenes, too"));
  }
  figures.push_back(figure("covers without R"));
  return figures;
}

/// Returns as many counts as model_figures() has, in its order.
StudyCounts count_study(const ModelCell& cell, const study::StudyRecords& records,
                        const FittedModels& models, const Truth& truth) {
  const Dataset set = select_for_analysis(records);
  const study::AnalysisPlan& plan = records.protocol.analysis;
  const auto planned_one = [&](const FittedModels& by_r) {
    return planned_primary_analyses(set, plan, by_r).front();
  };
  const auto primary = [&](const FittedModels& by_r) { return planned_one(by_r).primary; };
  if (is_separated(cell)) {
    StudyCounts found(2);
    for (const auto& [count, result] :
         {std::pair(&found.front(), primary(models)), std::pair(&found.back(), primary({}))}) {
      if (result && (count == &found.back() || result->instead.empty())) {
        count->add(result->p < plan.alpha);
      }
    }
    return found;
  }
  if (tests_equivalence(cell)) {
    StudyCounts declared(2);
    const auto is_declared = [&](const MethodComparison& found) {
      return found.equivalent && found.equivalent->p < plan.alpha;
    };
    declared.front().add(is_declared(planned_one(models)));
    declared.back().add(is_declared(planned_one({})));
    return declared;
  }
  const bool is_fixed = has_fixed_scenes(cell);
  const double planned = is_fixed ? truth.in_these_scenes : truth.in_all_scenes;
  StudyCounts counts(is_fixed ? 3 : 2);
  if (const auto found = primary(models); found && found->instead.empty()) {
    if (cell.is_rating) {
      counts.front().add(found->p >=
                         plan.alpha);  // equivalent to the interval covering no difference
    } else {
      counts.front().add(*found, planned);
    }
    if (is_fixed) {
      counts[1].add(*found, truth.in_all_scenes);
    }
  }
  if (const auto found = primary({}); found && found->interval) {
    counts.back().add(*found, planned);
  }
  return counts;
}

StudyCounts count_block(const ModelCell& cell, const ModelCoverageSettings& settings,
                        const ModelFitter& fit, std::size_t first, std::size_t last) {
  std::vector<study::StudyRecords> studies;
  for (std::size_t study = first; study < last; ++study) {
    studies.push_back(draw(cell, seed_of(cell, settings, study)));
  }
  const std::vector<FittedModels> models = fit(studies);
  StudyCounts counts(model_figures(cell).size());
  for (std::size_t i = 0; i < studies.size(); ++i) {
    if (const std::string why = missing_for(models[i]); !why.empty()) {
      throw Error("bench statistics --r", why, "install it, or remove --r");
    }
    const Truth truth = truth_of(cell, seed_of(cell, settings, first + i));
    add(count_study(cell, studies[i], models[i], truth), counts);
  }
  return counts;
}

}  // namespace

std::vector<ModelCell> model_cells() {
  std::vector<ModelCell> cells = {ordinal_cell(16), ordinal_cell(24)};
  for (const auto& [participants, scenes_gain] : {std::pair(16U, 0.1), std::pair(37U, 0.2)}) {
    for (const double censored : {0.13, 0.32, 0.5}) {
      cells.push_back(tobit_cell(participants, {.participants_gain = 0.1,
                                                .scenes_gain = scenes_gain,
                                                .censored = censored,
                                                .scenes = study::SceneEffects::fixed}));
    }
  }
  for (const auto& [participants, scenes_gain] : {std::pair(12U, 0.1), std::pair(40U, 0.2)}) {
    cells.push_back(tobit_cell(
        participants, {.participants_gain = 0.2, .scenes_gain = scenes_gain, .censored = 0.32}));
  }
  cells.push_back(crossed_cell(16));
  cells.push_back(crossed_cell(40));
  cells.push_back(separated_cell(16));
  for (const double ratio : {0.8, 1.0}) {
    for (const double censored : {0.0, 0.2, 0.4}) {
      cells.push_back(equivalence_cell(censored, ratio));
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i].stream = i;
  }
  return cells;
}

double expected_seconds(const std::vector<ModelCell>& cells, const ModelCoverageSettings& settings,
                        const ModelFitter& fit) {
  constexpr std::size_t unit = 100;  // one of this many studies is timed
  std::vector<study::StudyRecords> studies;
  std::size_t all = 0;
  for (const ModelCell& cell : cells) {
    all += study_count_of(cell, settings);
    const std::size_t timed = std::max<std::size_t>(study_count_of(cell, settings) / unit, 1);
    for (std::size_t study = 0; study < timed; ++study) {
      studies.push_back(draw(cell, seed_of(cell, settings, study)));
    }
  }
  const auto start = std::chrono::steady_clock::now();
  (void)fit(studies);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return taken.count() * static_cast<double>(all) / static_cast<double>(studies.size()) /
         Workers(settings.threads).threads();
}

std::vector<CoverageFigure> measure_model_coverage(const ModelCell& cell,
                                                   const ModelCoverageSettings& settings,
                                                   const ModelFitter& fit,
                                                   const std::stop_token& stop) {
  std::vector<CoverageFigure> figures = model_figures(cell);
  const StudyCounts counts =
      sum_of_blocks(figures.size(), study_count_of(cell, settings), studies_drawn_together,
                    Workers(settings.threads), [&](std::size_t first, std::size_t last) {
                      return stop.stop_requested() ? StudyCounts(figures.size())
                                                   : count_block(cell, settings, fit, first, last);
                    });
  if (stop.stop_requested()) {
    return {};
  }
  for (std::size_t i = 0; i < figures.size(); ++i) {
    figures[i] = measured(std::move(figures[i]), counts[i]);
  }
  return figures;
}

std::vector<FittedModels> fit_studies(const std::vector<study::StudyRecords>& studies) {
  const ScratchFolder scratch;
  const fs::path script = scratch / "models.R";
  write_file(script, models_script());
  std::vector<fs::path> folders;
  for (const study::StudyRecords& records : studies) {
    if (has_data(records)) {
      folders.push_back(scratch / fmt::format("{}", folders.size()));
      write_study(records, folders.back());
    }
  }
  std::vector<FittedModels> fitted;
  if (!folders.empty()) {
    fitted = fit_models(script, folders);
  }
  std::vector<FittedModels> all;
  auto next = fitted.begin();
  for (const study::StudyRecords& records : studies) {
    all.push_back(has_data(records) ? std::move(*next++)
                                    : FittedModels{.missing = "no session is completed"});
  }
  return all;
}

}  // namespace foveola::analysis
