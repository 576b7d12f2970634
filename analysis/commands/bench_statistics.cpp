#include "analysis/commands/bench_statistics.h"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/monte_carlo/coverage.h"
#include "analysis/monte_carlo/crossed_coverage.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"

namespace foveola::analysis {
namespace {

void print_json(const CoverageSettings& settings, const std::vector<CoverageFigure>& figures) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const CoverageFigure& figure : figures) {
    nlohmann::ordered_json row = {
        {"name", figure.name},        {"claim", figure.claim},        {"percent", figure.percent},
        {"low", figure.interval.low}, {"high", figure.interval.high}, {"studies", figure.studies},
        {"asked", nullptr},           {"met", figure.is_met()}};
    if (figure.required) {
      row["asked"] = {figure.required->low, figure.required->high};
    }
    rows.push_back(std::move(row));
  }
  const nlohmann::ordered_json json = {{"participants", settings.participants},
                                       {"seed", settings.seed},
                                       {"resamples", settings.resamples},
                                       {"participant_kind", "simulated"},
                                       {"figures", rows}};
  fmt::print("{}\n", json.dump(2));
}

void print_table(const CoverageSettings& settings, const std::vector<CoverageFigure>& figures) {
  std::size_t width = 0;
  for (const CoverageFigure& figure : figures) {
    width = std::max(width, figure.name.size());
  }
  fmt::print(
      "Studies of {} simulated participants whose times are drawn from a model; in brackets, "
      "95 % intervals of the shares\n",
      settings.participants);
  for (const CoverageFigure& figure : figures) {
    const std::string required =
        figure.required
            ? fmt::format("required: {} to {} %", figure.required->low, figure.required->high)
            : "reported only";
    fmt::print("{:<{}}  {:<26} {:6.2f} % [{:.2f}, {:.2f}] of {}; {}\n", figure.name, width,
               figure.claim, figure.percent, figure.interval.low, figure.interval.high,
               figure.studies, required);
  }
}

void run_bench_statistics(const CoverageSettings& settings, bool json,
                          const std::stop_token& stop) {
  std::vector<CoverageFigure> figures;
  {
    Progress progress("Studies with injected effects");
    figures = measure_coverage(
        settings, [&](double done) { progress.update(0.9 * done); }, stop);
    for (CoverageFigure& figure : measure_crossed_coverage(
             settings, [&](double done) { progress.update(0.9 + 0.1 * done); }, stop)) {
      figures.push_back(std::move(figure));
    }
  }
  json ? print_json(settings, figures) : print_table(settings, figures);
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

}  // namespace

void add_bench_statistics(CLI::App& bench, const std::stop_token& stop) {
  const auto settings = std::make_shared<CoverageSettings>();
  const auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "statistics",
      "Simulate studies with known effects; report how often intervals cover them and tests are "
      "right");
  command->add_option("--studies", settings->studies, "Studies to simulate for each figure")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
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
  command->add_flag("--json", *json, "Print the figures as JSON");
  command->footer("Example: foveola bench statistics --studies 4000");
  command->callback([=] { run_bench_statistics(*settings, *json, stop); });
}

}  // namespace foveola::analysis
