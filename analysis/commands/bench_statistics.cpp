#include "analysis/commands/bench_statistics.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/monte_carlo/censored_coverage.h"
#include "analysis/monte_carlo/coverage.h"
#include "analysis/monte_carlo/crossed_coverage.h"
#include "analysis/monte_carlo/fitted_studies.h"
#include "analysis/monte_carlo/model_coverage.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"

namespace foveola::analysis {
namespace {

void print_json(nlohmann::ordered_json json, const std::vector<CoverageFigure>& figures) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const CoverageFigure& figure : figures) {
    nlohmann::ordered_json row = {
        {"name", figure.name},        {"claim", figure.claim},        {"percent", figure.percent},
        {"low", figure.interval.low}, {"high", figure.interval.high}, {"studies", figure.studies},
        {"asked", nullptr},           {"met", figure.is_met()}};
    if (figure.mean_ratio) {
      row["mean_ratio"] = *figure.mean_ratio;
    }
    if (figure.required) {
      row["asked"] = {figure.required->low, figure.required->high};
    }
    rows.push_back(std::move(row));
  }
  json["participant_kind"] = "simulated";
  json["figures"] = std::move(rows);
  fmt::print("{}\n", json.dump(2));
}

std::size_t longest_name(const std::vector<CoverageFigure>& figures) {
  std::size_t width = 0;
  for (const CoverageFigure& figure : figures) {
    width = std::max(width, figure.name.size());
  }
  return width;
}

void print_figure(const CoverageFigure& figure, std::size_t width) {
  const std::string required =
      figure.required
          ? fmt::format("required: {} to {} %", figure.required->low, figure.required->high)
          : "reported only";
  const std::string mean =
      figure.mean_ratio ? fmt::format("; mean {:.1f} %", 100.0 * *figure.mean_ratio) : "";
  fmt::print("{:<{}}  {:<27} {:6.2f} % [{:.2f}, {:.2f}] of {}; {}{}\n", figure.name, width,
             figure.claim, figure.percent, figure.interval.low, figure.interval.high,
             figure.studies, required, mean);
}

void print_table(const CoverageSettings& settings, const std::vector<CoverageFigure>& figures) {
  fmt::print(
      "Studies of {} simulated participants whose times are drawn from a model; in brackets, "
      "95 % intervals of the shares\n",
      settings.participants);
  const std::size_t width = longest_name(figures);
  for (const CoverageFigure& figure : figures) {
    print_figure(figure, width);
  }
}

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

void run_bench_statistics(const CoverageSettings& settings, bool json,
                          const std::stop_token& stop) {
  std::vector<CoverageFigure> figures;
  {
    Progress progress("Studies with injected effects");
    const auto add = [&](std::vector<CoverageFigure> others) {
      std::move(others.begin(), others.end(), std::back_inserter(figures));
    };
    // The shares of the time that they take.
    add(measure_coverage(settings, [&](double done) { progress.update(0.5 * done); }, stop));
    add(measure_crossed_coverage(
        settings, [&](double done) { progress.update(0.5 + 0.1 * done); }, stop));
    add(measure_censored_coverage(
        settings, [&](double done) { progress.update(0.6 + 0.4 * done); }, stop));
  }
  if (json) {
    print_json({{"participants", settings.participants},
                {"seed", settings.seed},
                {"resamples", settings.resamples}},
               figures);
  } else {
    print_table(settings, figures);
  }
  require_all(figures);
}

/// Prints the figures of each cell as soon as there are any: R takes its time.
void run_bench_of_models(const ModelCoverageSettings& settings, const std::string& only, bool json,
                         const std::stop_token& stop) {
  std::vector<ModelCell> cells = model_cells();
  std::erase_if(cells,
                [&](const ModelCell& cell) { return cell.name.find(only) == cell.name.npos; });
  if (cells.empty()) {
    throw UsageError("--only", fmt::format("no cell has \"{}\" in its name", only),
                     "use Tobit, crossed or ordinal");
  }
  std::size_t width = 0;
  for (const ModelCell& cell : cells) {
    width = std::max(width, cell.name.size());
  }
  if (!json) {
    fmt::print(
        "Studies with models by R, {} of twelve cells; in brackets, 95 % intervals of the shares. "
        "This takes about {}.\n",
        cells.size(), human_duration(expected_seconds(cells, settings, fit_studies)));
    std::fflush(stdout);
  }
  std::vector<CoverageFigure> figures;
  for (const ModelCell& cell : cells) {
    for (CoverageFigure& figure : measure_model_coverage(cell, settings, fit_studies, stop)) {
      if (!json) {
        print_figure(figure, width);
        std::fflush(stdout);
      }
      figures.push_back(std::move(figure));
    }
  }
  if (json) {
    print_json({{"seed", settings.seed}}, figures);
  }
  require_all(figures);
}

}  // namespace

void add_bench_statistics(CLI::App& bench, const std::stop_token& stop) {
  const auto settings = std::make_shared<CoverageSettings>();
  const auto studies = std::make_shared<std::optional<int>>();
  const auto json = std::make_shared<bool>(false);
  const auto r = std::make_shared<bool>(false);
  const auto only = std::make_shared<std::string>();
  CLI::App* command = bench.add_subcommand(
      "statistics",
      "Simulate studies with known effects; report how often intervals cover them and tests are "
      "right");
  command
      ->add_option("--studies", *studies,
                   fmt::format("Studies to simulate for each figure (default {}, with --r {}, and "
                               "two fifths of them for ordinal models)",
                               settings->studies, ModelCoverageSettings{}.studies))
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--participants", settings->participants, "Participants in each study")
      ->check(CLI::Range(2, 10'000))
      ->capture_default_str();
  command
      ->add_option("--seed", settings->seed,
                   "Seed of the simulation: the same seed gives the same figures")
      ->capture_default_str();
  command->add_option("--resamples", settings->resamples, "Resamples of each bootstrap interval")
      ->check(CLI::Range(99, 99'999))
      ->capture_default_str();
  command->add_option("--threads", settings->threads, "Threads to use; 0 takes every core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  CLI::Option* by_r = command->add_flag(
      "--r", *r,
      "Instead, how often the models that R fits are right, in twelve cells: Tobit, crossed with "
      "gaps, ordinal; needs R, and half an hour of one core");
  command->add_option("--only", *only, "With --r, only the cells with this in their names: Tobit")
      ->needs(by_r);
  command->add_flag("--json", *json, "Print the figures as JSON");
  command->footer("Example: foveola bench statistics --studies 4000");
  command->callback([=] {
    if (*r) {
      ModelCoverageSettings of_models{.seed = settings->seed, .threads = settings->threads};
      of_models.studies = static_cast<std::size_t>(studies->value_or(500));
      run_bench_of_models(of_models, *only, *json, stop);
    } else {
      settings->studies = studies->value_or(settings->studies);
      run_bench_statistics(*settings, *json, stop);
    }
  });
}

}  // namespace foveola::analysis
