#include "analysis/commands/bench_statistics.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/commands/coverage_report.h"
#include "analysis/commands/statistics_part.h"
#include "analysis/monte_carlo/censored_coverage.h"
#include "analysis/monte_carlo/coverage.h"
#include "analysis/monte_carlo/crossed_coverage.h"
#include "analysis/monte_carlo/fitted_studies.h"
#include "analysis/monte_carlo/model_coverage.h"
#include "renderer/base/error.h"
#include "renderer/base/print.h"
#include "renderer/base/progress.h"

namespace foveola::analysis {
namespace {

struct StatisticsArguments {
  CoverageSettings settings;
  std::optional<int> studies;  ///< empty: the default, which differs with R
  bool by_r = false;
  std::string only;
  bool json = false;
  BenchPartArguments part;
};

// --- Without R ---

template <typename Item>
void append(std::vector<Item> items, std::vector<Item>& all) {
  std::ranges::move(items, std::back_inserter(all));
}

std::vector<CoverageFigure> all_figures() {
  std::vector<CoverageFigure> figures = injected_figures();
  append(crossed_figures(), figures);
  append(censored_figures(), figures);
  return figures;
}

/// The counts of all_figures(); empty when stopped.
StudyCounts count_all(const CoverageSettings& settings, const ItemRange& studies,
                      const std::stop_token& stop) {
  Progress progress("Studies with injected effects");
  /// The shares of the time that they take.
  const auto share = [&](double begin, double end) {
    return [&progress, begin, end](double done) { progress.update(begin + (end - begin) * done); };
  };
  StudyCounts counts = count_injected_coverage(settings, studies, share(0.0, 0.5), stop);
  append(count_crossed_coverage(settings, studies, share(0.5, 0.6), stop), counts);
  append(count_censored_coverage(settings, studies, share(0.6, 1.0), stop), counts);
  return stop.stop_requested() ? StudyCounts() : counts;
}

void report(const CoverageSettings& settings, const StudyCounts& counts, bool json) {
  const std::vector<CoverageFigure> figures = measured(all_figures(), counts);
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

// --- With R ---

std::vector<ModelCell> cells_of(const std::string& only) {
  std::vector<ModelCell> cells = model_cells();
  std::erase_if(cells,
                [&](const ModelCell& cell) { return cell.name.find(only) == cell.name.npos; });
  if (cells.empty()) {
    throw UsageError("--only", fmt::format("no cell has \"{}\" in its name", only),
                     "use Tobit, crossed, ordinal or equivalence");
  }
  return cells;
}

/// Where the counts of a cell come from; empty when stopped.
using CellCounts = std::function<StudyCounts(const ModelCell& cell)>;

/// Prints the figures of each cell as soon as there are any: R takes its time.
void report(const ModelBench& bench, const CellCounts& counts_of, bool json) {
  const std::vector<ModelCell> cells = cells_of(bench.only);
  std::size_t width = 0;
  for (const ModelCell& cell : cells) {
    width = std::max(width, cell.name.size());
  }
  if (!json) {
    print_text(
        "Studies with models by R, {} of nineteen cells; in brackets, 95 % intervals of the "
        "shares.\n",
        cells.size());
    std::fflush(stdout);
  }
  std::vector<CoverageFigure> figures;
  for (const ModelCell& cell : cells) {
    for (CoverageFigure& figure : measured(model_figures(cell), counts_of(cell))) {
      if (!json) {
        print_figure(figure, width);
        std::fflush(stdout);
      }
      figures.push_back(std::move(figure));
    }
  }
  if (json) {
    print_json({{"seed", bench.settings.seed}}, figures);
  }
  require_all(figures);
}

void print_time_needed(const ModelBench& bench, const Shard& shard) {
  const double seconds = expected_seconds(cells_of(bench.only), bench.settings, fit_studies);
  print_text(stderr, "This takes about {}.\n",
             human_duration(seconds / static_cast<double>(shard.count)));
}

/// The counts of all cells, one after the other.
StudyCounts count_part(const ModelBench& bench, const Shard& shard, const std::stop_token& stop) {
  StudyCounts counts;
  for (const ModelCell& cell : cells_of(bench.only)) {
    append(count_model_coverage(cell, bench.settings, studies_of(cell, bench.settings, shard),
                                fit_studies, stop),
           counts);
  }
  return counts;
}

void merge_models(const std::vector<BenchPart>& parts, bool json) {
  const ModelBench bench = model_bench_of(parts.front());
  std::size_t figures = 0;
  for (const ModelCell& cell : cells_of(bench.only)) {
    figures += model_figures(cell).size();
  }
  const StudyCounts counts = merged_counts(parts, figures);
  auto next = counts.begin();
  report(
      bench,
      [&](const ModelCell& cell) {
        const auto first = next;
        next += static_cast<std::ptrdiff_t>(model_figures(cell).size());
        return StudyCounts(first, next);
      },
      json);
}

// --- The command ---

void write_part(const StatisticsArguments& arguments, const BenchPart& part,
                const std::stop_token& stop) {
  require_finished(arguments.part.output, stop.stop_requested());
  write_bench_part(arguments.part.output, part);
  print_written(arguments.part.output, part, arguments.json);
}

void run_without_r(const StatisticsArguments& arguments, const std::stop_token& stop) {
  CoverageSettings settings = arguments.settings;
  settings.studies = arguments.studies.value_or(settings.studies);
  const std::optional<Shard> shard = shard_of(arguments.part);
  const StudyCounts counts =
      count_all(settings, part_of(shard.value_or(Shard{}), settings.studies), stop);
  if (shard) {
    write_part(arguments,
               {.command = statistics_command,
                .shard = *shard,
                .settings = settings_json(settings),
                .results = counts_json(counts),
                .file = {}},
               stop);
  } else if (!stop.stop_requested()) {
    report(settings, counts, arguments.json);
  }
}

void run_by_r(const StatisticsArguments& arguments, const std::stop_token& stop) {
  ModelBench bench{
      .settings = {.seed = arguments.settings.seed, .threads = arguments.settings.threads},
      .only = arguments.only,
      .fitted_by = {}};
  if (arguments.studies) {
    bench.settings.studies = static_cast<std::size_t>(*arguments.studies);
  }
  const std::vector<ModelCell> cells = cells_of(bench.only);
  const std::optional<Shard> shard = shard_of(arguments.part);
  if (shard) {
    bench.fitted_by = fitted_by(cells.front(), bench.settings, fit_studies);
  }
  if (!arguments.json) {
    print_time_needed(bench, shard.value_or(Shard{}));
  }
  if (shard) {
    const StudyCounts counts = count_part(bench, *shard, stop);
    write_part(arguments,
               {.command = statistics_command,
                .shard = *shard,
                .settings = settings_json(bench),
                .results = counts_json(counts),
                .file = {}},
               stop);
    return;
  }
  report(
      bench,
      [&](const ModelCell& cell) {
        return count_model_coverage(cell, bench.settings, studies_of(cell, bench.settings),
                                    fit_studies, stop);
      },
      arguments.json);
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
      ->check(CLI::Range(2, 10'000))
      ->capture_default_str();
  command
      ->add_option("--seed", settings.seed,
                   "Seed of the simulation: the same seed gives the same figures")
      ->capture_default_str();
  command->add_option("--resamples", settings.resamples, "Resamples of each bootstrap interval")
      ->check(CLI::Range(99, 99'999))
      ->capture_default_str();
  command->add_option("--threads", settings.threads, "Threads to use; 0 takes every core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  CLI::Option* by_r = command->add_flag(
      "--r", arguments->by_r,
      "Instead, how often the models that R fits are right, in nineteen cells: Tobit, crossed with "
      "gaps, ordinal, equivalence; needs R, and half an hour of one core");
  command
      ->add_option("--only", arguments->only,
                   "With --r, only the cells with this in their names: Tobit")
      ->needs(by_r);
  add_bench_part_options(*command, arguments->part);
  command->add_flag("--json", arguments->json, "Print the figures as JSON");
  command->footer("Example: foveola bench statistics --studies 4000");
  command->callback([arguments, stop] {
    arguments->by_r ? run_by_r(*arguments, stop) : run_without_r(*arguments, stop);
  });
}

void merge_statistics(const std::vector<BenchPart>& parts, bool json) {
  if (is_of_models(parts.front())) {
    merge_models(parts, json);
    return;
  }
  const CoverageSettings settings = coverage_settings_of(parts.front());
  report(settings, merged_counts(parts, all_figures().size()), json);
}

}  // namespace foveola::analysis
