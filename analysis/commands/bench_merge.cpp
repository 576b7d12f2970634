#include "analysis/commands/bench_merge.h"

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/commands/bench_convergence.h"
#include "analysis/commands/bench_statistics.h"
#include "analysis/commands/convergence_part.h"
#include "analysis/commands/statistics_part.h"
#include "renderer/base/error.h"
#include "renderer/commands/bench_part.h"
#include "renderer/commands/bench_stability.h"

namespace foveola::analysis {
namespace {

struct MergeArguments {
  std::vector<std::string> parts;
  std::string output;
  bool json = false;
};

void run(const MergeArguments& arguments) {
  const std::vector<BenchPart> parts =
      read_whole_bench({arguments.parts.begin(), arguments.parts.end()});
  const BenchPart& first = parts.front();
  if ((first.command == convergence_command) == arguments.output.empty()) {
    throw UsageError("--output", arguments.output.empty()
                                     ? "is required: bench convergence writes files"
                                     : fmt::format("is for parts of bench {}, and these are of "
                                                   "bench {}, which only prints",
                                                   convergence_command, first.command));
  }
  if (first.command == statistics_command) {
    merge_statistics(parts, arguments.json);
  } else if (first.command == stability_command) {
    merge_stability(parts, arguments.json);
  } else if (first.command == convergence_command) {
    merge_convergence(parts, arguments.output, arguments.json);
  } else {
    throw Error(first.file.string(), "is of bench " + first.command + ", which has no parts",
                "name files that foveola bench has written with --shard");
  }
}

}  // namespace

void add_bench_merge(CLI::App& bench) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command = bench.add_subcommand(
      "merge", "Make of a benchmark's parts, measured with --shard, what it is as a whole");
  command->add_option("PART", arguments->parts, "The file of each part, in any order")->required();
  command->add_option("-o,--output", arguments->output,
                      "Of parts of bench convergence, the folder for tables and figures; made if "
                      "its parent exists");
  command->add_flag("--json", arguments->json, "Print the figures as JSON");
  command->footer(
      "Example: foveola bench statistics --shard 1/2 -o 1.json (and 2/2, elsewhere), then\n"
      "         foveola bench merge 1.json 2.json");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace foveola::analysis
