#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/commands/commands.h"
#include "analysis/replication/bench_ratios.h"
#include "analysis/tables/table.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

struct CompareArguments {
  std::string before;
  std::string after;
  bool all = false;
  bool json = false;
};

const char* name_of(BenchMove move) {
  switch (move) {
    case BenchMove::alone:
      return "alone";
    case BenchMove::together:
      return "together";
    case BenchMove::exactly:
      return "exactly";
    case BenchMove::without_interval:
      return "without_interval";
    case BenchMove::none:
      break;
  }
  return "no";
}

/// Returns the expected number of figures beyond their own 95 % confidence intervals by chance.
double expected_by_chance(const BenchComparison& comparison) {
  return 0.05 * static_cast<double>(comparison.count(BenchFigureKind::with_interval));
}

Table ratios_table(const BenchComparison& comparison) {
  using R = BenchRatio;
  const ColumnsOf<R> columns = {
      {"name", "", "Place of the figure", &R::figure},
      {"before", "", "The figure of the first run", &R::before},
      {"after", "", "The figure of the second run", &R::after},
      {"value", "", "after / before", &R::ratio},
      {"low", "", "Lower 95 % confidence limit of value", path(&R::interval, &Interval::low)},
      {"high", "", "Upper 95 % confidence limit of value", path(&R::interval, &Interval::high)},
      {"low_together", "", "Lower limit of value, 95 % for all figures simultaneously",
       path(&R::together, &Interval::low)},
      {"high_together", "", "Upper limit of value, 95 % for all figures simultaneously",
       path(&R::together, &Interval::high)},
      {"exact", "", "Whether the figure is bit-identical on one machine",
       [](const R& row) { return row.kind == BenchFigureKind::exact; }},
      {"moved", "", "Interval beyond which the figure moved, or no",
       [](const R& row) { return name_of(row.move); }}};
  return tabulate("ratios", "figure of both runs", columns, comparison.ratios);
}

void print_json(const BenchComparison& comparison) {
  const nlohmann::ordered_json differing(
      transformed(comparison.differing, [&](const std::string& difference) {
        return nlohmann::ordered_json{{"setting", difference}};
      }));
  const nlohmann::ordered_json json = {
      {"moved_together", comparison.moved(BenchMove::together).size()},
      {"beyond_own_interval_alone", comparison.moved(BenchMove::alone).size()},
      {"expected_beyond_by_chance", expected_by_chance(comparison)},
      {"exact_that_differ", comparison.moved(BenchMove::exactly).size()},
      {"differ_without_interval", comparison.moved(BenchMove::without_interval).size()},
      {"figures_with_interval", comparison.count(BenchFigureKind::with_interval)},
      {"level_of_each_together", comparison.level_of_each},
      {"ratios", json_of(ratios_table(comparison))},
      {"differing_settings", differing},
      {"in_one_run_only", comparison.unmatched}};
  print_text("{}\n", json.dump(2));
}

std::string ratio_text(const BenchRatio& row, const std::optional<Interval>& interval) {
  if (!row.ratio) {
    return "-";
  }
  return fmt::format(
      "{:.3f}{}", *row.ratio,
      interval ? fmt::format(" ({:.3f} to {:.3f})", interval->low, interval->high) : "");
}

/// Prints exact figures with all digits: they may differ in the last.
void print_rows(const std::vector<BenchRatio>& rows, BenchMove move) {
  std::size_t width = 0;
  for (const BenchRatio& row : rows) {
    width = std::max(width, row.figure.size());
  }
  for (const BenchRatio& row : rows) {
    if (row.kind == BenchFigureKind::exact) {
      print_text("  {:<{}}  {}, now {}\n", row.figure, width, row.before, row.after);
    } else {
      print_text("  {:<{}}  {:.5g}, now {:.5g}: {}\n", row.figure, width, row.before, row.after,
                 ratio_text(row, move == BenchMove::together ? row.together : row.interval));
    }
  }
}

std::string moved_heading(BenchMove move, const BenchComparison& comparison, std::size_t moved) {
  const std::size_t intervals = comparison.count(BenchFigureKind::with_interval);
  switch (move) {
    case BenchMove::together:
      return fmt::format(
          "Moved: {} of {} figures with intervals, by simultaneous intervals with "
          "95 % ({:.3f} % each)",
          moved, intervals, 100.0 * comparison.level_of_each);
    case BenchMove::alone:
      return fmt::format(
          "Beyond their own 95 % confidence intervals only: {}; of {} figures that did not move, "
          "about {:.2g} "
          "are expected by chance",
          moved, intervals, expected_by_chance(comparison));
    case BenchMove::exactly:
      return fmt::format("Exact figures that differ: {} of {}", moved,
                         comparison.count(BenchFigureKind::exact));
    default:
      return fmt::format("Differ, without an interval: {}", moved);
  }
}

void print_moves(const BenchComparison& comparison) {
  for (const BenchMove move :
       {BenchMove::together, BenchMove::exactly, BenchMove::alone, BenchMove::without_interval}) {
    const std::vector<BenchRatio> rows = comparison.moved(move);
    print_text("{}\n", moved_heading(move, comparison, rows.size()));
    print_rows(rows, move);
  }
  print_text("Stayed: {} of {} figures\n", comparison.moved(BenchMove::none).size(),
             comparison.ratios.size());
}

void print_table(const BenchComparison& comparison) {
  std::size_t width = 0;
  for (const BenchRatio& row : comparison.ratios) {
    width = std::max(width, row.figure.size());
  }
  print_text("\n{:<{}}  {:>12}  {:>12}  {}\n", "figure", width, "before", "after",
             "after / before");
  for (const BenchRatio& row : comparison.ratios) {
    print_text("{:<{}}  {:>12.5g}  {:>12.5g}  {}\n", row.figure, width, row.before, row.after,
               ratio_text(row, row.interval));
  }
}

void print_differences(const BenchComparison& comparison) {
  for (const std::string& difference : comparison.differing) {
    print_text("Differs: {}\n", difference);
  }
  if (const std::size_t count = comparison.unmatched.size(); count > 0) {
    print_text("{} figure{} in one run only; --json names {}\n", count, count == 1 ? "" : "s",
               count == 1 ? "it" : "them");
  }
}

}  // namespace

void add_bench_compare(CLI::App& bench) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = bench.add_subcommand(
      "compare", "Compare two runs of a benchmark: what moved beyond its interval");
  command->add_option("BEFORE", arguments->before, "The --json output of a bench command")
      ->required();
  command
      ->add_option("AFTER", arguments->after,
                   "The --json output of the same command at another time")
      ->required();
  command->add_flag("--all", arguments->all, "Print all figures, not only those that moved");
  command->add_flag("--json", arguments->json, "Print the ratios as JSON");
  command->footer("Example: foveola bench compare before.json after.json");
  command->callback([arguments] {
    const BenchComparison comparison =
        compare_benches(read_file(arguments->before), arguments->before,
                        read_file(arguments->after), arguments->after);
    if (arguments->json) {
      print_json(comparison);
      return;
    }
    print_moves(comparison);
    print_differences(comparison);
    if (arguments->all) {
      print_table(comparison);
    }
  });
}

}  // namespace foveola::analysis
