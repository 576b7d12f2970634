#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/commands/commands.h"
#include "analysis/monte_carlo/censored_coverage.h"
#include "analysis/monte_carlo/coverage.h"
#include "analysis/monte_carlo/model_coverage.h"
#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/bench_facts.h"

namespace foveola::analysis {
namespace {

/// Prints a line on standard output; its name takes `width` letters.
void print_figure(const CoverageFigure& figure, std::size_t width) {
  const std::string required =
      figure.required
          ? fmt::format("required: {} to {} %", figure.required->low, figure.required->high)
          : "reported only";
  const std::string mean =
      figure.mean_ratio ? fmt::format("; mean {:.1f} %", 100.0 * *figure.mean_ratio) : "";
  print_text("{:<{}}  {:<27} {:6.2f} % [{:.2f}, {:.2f}] of {}; {}{}\n", figure.name, width,
             figure.claim, figure.percent, figure.interval.low, figure.interval.high,
             figure.studies, required, mean);
}

/// Prints all figures as lines on standard output, after a description of the studies.
void print_table(const CoverageSettings& settings, const std::vector<CoverageFigure>& figures) {
  print_text(
      "Studies of {} simulated participants whose times are drawn from a model; in brackets, "
      "95 % confidence intervals of the shares\n",
      settings.participants);
  std::size_t width = 0;
  for (const CoverageFigure& figure : figures) {
    width = std::max(width, figure.name.size());
  }
  for (const CoverageFigure& figure : figures) {
    print_figure(figure, width);
  }
}

/// Prints one object on standard output: the members of `about`, then the figures.
void print_json(const nlohmann::ordered_json& about, const std::vector<CoverageFigure>& figures) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const CoverageFigure& figure : figures) {
    nlohmann::ordered_json row = {{"name", figure.name},          {"claim", figure.claim},
                                  {"percent", figure.percent},    {"low", figure.interval.low},
                                  {"high", figure.interval.high}, {"studies", figure.studies},
                                  {"hits", figure.hits},          {"asked", nullptr},
                                  {"met", figure.is_met()}};
    if (figure.mean_ratio) {
      row["mean_ratio"] = *figure.mean_ratio;
    }
    if (figure.required) {
      row["asked"] = {figure.required->low, figure.required->high};
    }
    rows.push_back(std::move(row));
  }
  nlohmann::ordered_json json = bench_facts();
  json.update(about);
  json["participant_kind"] = "simulated";
  json["figures"] = std::move(rows);
  print_text("{}\n", json.dump(2));
}

/// Throws Error for the first figure outside of its required range.
void require_all(const std::vector<CoverageFigure>& figures) {
  for (const CoverageFigure& figure : figures) {
    if (!figure.is_met()) {
      throw Error(
          figure.name,
          fmt::format("{} in {:.2f} % of studies, not in {} to {} %", figure.claim, figure.percent,
                      figure.required->low, figure.required->high),
          "with fewer than 4000 studies this may be chance; otherwise the analysis is wrong");
    }
  }
}

struct StatisticsArguments {
  CoverageSettings settings;
  std::optional<std::size_t> studies;  ///< empty: the default, which depends on --r
  bool by_r = false;
  std::string only;
  bool json = false;
};

void run_without_r(const StatisticsArguments& arguments, const std::stop_token& stop) {
  CoverageSettings settings = arguments.settings;
  settings.studies = arguments.studies.value_or(settings.studies);
  std::vector<CoverageFigure> figures;
  {
    Progress progress("Studies with injected effects");
    // Adds the figures of one kind, whose progress runs from begin to end.
    const auto measure = [&](const auto& measure_coverage, double begin, double end) {
      std::ranges::move(
          measure_coverage(
              settings, [&](double done) { progress.update(begin + (end - begin) * done); }, stop),
          std::back_inserter(figures));
    };
    measure(measure_injected_coverage, 0.0, 0.5);
    measure(measure_crossed_coverage, 0.5, 0.6);
    measure(measure_censored_coverage, 0.6, 1.0);
  }
  if (stop.stop_requested()) {
    return;
  }
  if (arguments.json) {
    print_json({{"participants", settings.participants},
                {"seed", settings.seed},
                {"resamples", settings.resamples}},
               figures);
  } else {
    print_table(settings, figures);
  }
  require_all(figures);
}

std::vector<ModelCell> cells_of(const std::string& only) {
  std::vector<ModelCell> cells = model_cells();
  std::erase_if(cells,
                [&](const ModelCell& cell) { return cell.name.find(only) == cell.name.npos; });
  if (cells.empty()) {
    throw UsageError("--only", fmt::format("\"{}\" is not in the name of any cell", only),
                     "use Tobit, crossed, ordinal or equivalence");
  }
  return cells;
}

/// Prints the figures of each cell at once, since R is slow.
void run_by_r(const StatisticsArguments& arguments, const std::stop_token& stop) {
  ModelCoverageSettings settings{.seed = arguments.settings.seed,
                                 .threads = arguments.settings.threads};
  settings.studies = arguments.studies.value_or(settings.studies);
  const std::vector<ModelCell> cells = cells_of(arguments.only);
  std::size_t width = 0;
  for (const ModelCell& cell : cells) {
    width = std::max(width, cell.name.size());
  }
  if (!arguments.json) {
    print_text(stderr, "This takes about {}.\n",
               human_duration(expected_seconds(cells, settings, fit_studies)));
    print_text(
        "Studies with models by R, {} of nineteen cells; in brackets, 95 % confidence intervals of "
        "the "
        "shares.\n",
        cells.size());
    std::fflush(stdout);
  }
  std::vector<CoverageFigure> figures;
  for (const ModelCell& cell : cells) {
    for (CoverageFigure& figure : measure_model_coverage(cell, settings, fit_studies, stop)) {
      if (!arguments.json) {
        print_figure(figure, width);
        std::fflush(stdout);
      }
      figures.push_back(std::move(figure));
    }
  }
  if (arguments.json) {
    print_json({{"seed", settings.seed}}, figures);
  }
  require_all(figures);
}

}  // namespace

void add_bench_statistics(CLI::App& bench, const std::stop_token& stop) {
  const auto arguments = std::make_shared<StatisticsArguments>();
  CoverageSettings& settings = arguments->settings;
  CLI::App* command = bench.add_subcommand(
      "statistics",
      "Simulate studies with known effects; report how often intervals cover them and tests are "
      "right");
  command
      ->add_option("--studies", arguments->studies,
                   fmt::format("Studies to simulate for each figure (default {}, with --r {}, and "
                               "two fifths of them for ordinal models)",
                               settings.studies, ModelCoverageSettings{}.studies))
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--participants", settings.participants, "Participants in each study")
      ->check(CLI::Range(2, 10'000));
  command->add_option("--seed", settings.seed,
                      "Seed of the simulation: the same seed gives the same figures");
  command->add_option("--resamples", settings.resamples, "Resamples of each bootstrap interval")
      ->check(CLI::Range(99, 99'999));
  add_threads_option(*command, settings.threads);
  CLI::Option* by_r = command->add_flag(
      "--r", arguments->by_r,
      "Instead, measure the coverage of R's models in nineteen cells: Tobit, crossed with "
      "gaps, ordinal, equivalence; needs R, and half an hour of one core");
  command
      ->add_option("--only", arguments->only,
                   "With --r, only the cells with this in their names: Tobit")
      ->needs(by_r);
  command->add_flag("--json", arguments->json, "Print the figures as JSON");
  command->footer("Example: foveola bench statistics --studies 4000");
  command->callback([arguments, stop] {
    arguments->by_r ? run_by_r(*arguments, stop) : run_without_r(*arguments, stop);
  });
}

}  // namespace foveola::analysis
