#include "analysis/commands/bench_compare.h"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/commands/bench_ratios.h"
#include "renderer/base/files.h"

namespace foveola::analysis {
namespace {

struct CompareArguments {
  std::string before;
  std::string after;
  bool json = false;
};

void print_json(const BenchComparison& comparison) {
  nlohmann::ordered_json ratios = nlohmann::ordered_json::array();
  for (const BenchRatio& row : comparison.ratios) {
    nlohmann::ordered_json entry = {{"name", row.figure}, {"before", row.before},
                                    {"after", row.after}, {"value", row.ratio},
                                    {"low", nullptr},     {"high", nullptr}};
    if (row.interval) {
      entry["low"] = row.interval->low;
      entry["high"] = row.interval->high;
    }
    ratios.push_back(std::move(entry));
  }
  const nlohmann::ordered_json json = {{"ratios", ratios},
                                       {"differing_settings", comparison.differing},
                                       {"without_ratio", comparison.unmatched}};
  fmt::print("{}\n", json.dump(2));
}

void print_table(const BenchComparison& comparison) {
  std::size_t width = 0;
  for (const BenchRatio& row : comparison.ratios) {
    width = std::max(width, row.figure.size());
  }
  fmt::print("{:<{}}  {:>12}  {:>12}  {}\n", "figure", width, "before", "after", "after / before");
  for (const BenchRatio& row : comparison.ratios) {
    const std::string interval =
        row.interval ? fmt::format(" ({:.3f} to {:.3f})", row.interval->low, row.interval->high)
                     : "";
    fmt::print("{:<{}}  {:>12.5g}  {:>12.5g}  {:.3f}{}\n", row.figure, width, row.before, row.after,
               row.ratio, interval);
  }
  for (const std::string& setting : comparison.differing) {
    fmt::print("Differs: {}\n", setting);
  }
  if (const std::size_t count = comparison.unmatched.size(); count > 0) {
    fmt::print("{} figure{} without a ratio; --json names {}\n", count, count == 1 ? "" : "s",
               count == 1 ? "it" : "them");
  }
}

}  // namespace

void add_bench_compare(CLI::App& bench) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      bench.add_subcommand("compare", "Compare two runs of a benchmark: ratios with intervals");
  command->add_option("BEFORE", arguments->before, "What a bench command printed with --json")
      ->required();
  command->add_option("AFTER", arguments->after, "What the same command printed at another time")
      ->required();
  command->add_flag("--json", arguments->json, "Print the ratios as JSON");
  command->footer("Example: foveola bench compare before.json after.json");
  command->callback([arguments] {
    const BenchComparison comparison =
        compare_benches(read_file(arguments->before), arguments->before,
                        read_file(arguments->after), arguments->after);
    arguments->json ? print_json(comparison) : print_table(comparison);
  });
}

}  // namespace foveola::analysis
