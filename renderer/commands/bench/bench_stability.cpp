#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/bench/bench_commands.h"
#include "renderer/commands/bench_facts.h"
#include "renderer/stability/checks.h"

namespace foveola {
namespace {

struct StabilityArguments {
  bool quick = false;
  bool full = false;
  bool json = false;
  std::string only;
  int threads = 0;
  std::uint64_t scene_paths = 0;
  std::uint32_t scene_seed = 1;
};

StabilityEffort effort_of(const StabilityArguments& arguments) {
  StabilityEffort effort = thorough_effort;
  if (arguments.quick) {
    effort = quick_effort;
  } else if (arguments.full) {
    effort = full_effort;
  }
  effort.scene_seed = arguments.scene_seed;
  if (arguments.scene_paths > 0) {
    effort.scene_paths = arguments.scene_paths;
  }
  return effort;
}

/// All stress tests, or those with `only` in their name.
std::vector<StabilityCheck> chosen_checks(const std::vector<SceneSource>& scenes,
                                          const std::string& only) {
  std::vector<StabilityCheck> checks = stability_checks(scenes);
  const std::vector<std::string> names = transformed(checks, &StabilityCheck::name);
  std::erase_if(checks,
                [&](const auto& check) { return check.name.find(only) == std::string::npos; });
  if (checks.empty()) {
    throw Error("--only", fmt::format("there is no stress test {}", only),
                fmt::format("there are: {}", fmt::join(names, ", ")));
  }
  return checks;
}

/// Default number of threads: at least four, also on fewer cores. Bits must be equal on four
/// threads, and TBB starts no more than its first user allows.
int thread_count(const StabilityArguments& arguments) {
  const int cores = usable_cores();
  return arguments.threads > 0 ? arguments.threads : std::max(4, cores);
}

std::vector<SceneSource> found(const std::vector<std::string>& names,
                               const SceneFinder& find_scene) {
  return transformed(names, [&](const std::string& name) { return find_scene(name); });
}

nlohmann::json json_of(const StabilityFigure& figure) {
  nlohmann::json measured = nullptr;  // JSON has no NaN
  if (std::isfinite(figure.measured)) {
    measured = figure.measured;
  }
  return {{"name", figure.name}, {"measured", measured},      {"bound", figure.bound},
          {"unit", figure.unit}, {"passes", figure.passes()}, {"details", figure.details}};
}

void print_json(const std::vector<StabilityFigure>& figures, int threads, double duration_s) {
  const nlohmann::json list(
      transformed(figures, [&](const StabilityFigure& figure) { return json_of(figure); }));
  nlohmann::json json(bench_facts());
  json.update({{"threads", threads}, {"seconds", measured_once(duration_s)}, {"figures", list}});
  print_text("{}\n", json.dump(2));
}

void print_table(const std::vector<StabilityFigure>& figures, double duration_s) {
  std::size_t width = 0;
  for (const StabilityFigure& figure : figures) {
    width = std::max(width, figure.name.size());
  }
  print_text("{:<{}}  {:>12}  {:>12}  {}\n", "figure", width, "at most", "measured", "verdict");
  for (const StabilityFigure& figure : figures) {
    print_text("{:<{}}  {:>12.4g}  {:>12.4g}  {}  {}\n", figure.name, width, figure.bound,
               figure.measured, figure.passes() ? "pass" : "FAIL", figure.unit);
    if (!figure.passes()) {
      print_text("    {}\n", figure.details);
    }
  }
  print_text("{} figures in {}\n", figures.size(), human_duration(duration_s));
}

void require_all(const std::vector<StabilityFigure>& figures) {
  const auto failures =
      std::ranges::count_if(figures, [](const auto& figure) { return !figure.passes(); });
  if (failures > 0) {
    throw Error("bench stability",
                fmt::format("{} of {} figures exceed their bounds", failures, figures.size()),
                "see the table; --json has the details of all");
  }
}

void run_stability(const StabilityArguments& arguments, const std::vector<SceneSource>& scenes,
                   const std::stop_token& stop) {
  const std::vector<StabilityCheck> checks = chosen_checks(scenes, arguments.only);
  const SteadyClock clock;
  const Workers workers(thread_count(arguments));
  const Nanoseconds start = clock.now();
  std::vector<StabilityFigure> figures;
  {
    Progress progress("numerical stability");
    figures = measure_stability(
        checks, effort_of(arguments), workers,
        [&](double fraction, const std::string& test) { progress.update(fraction, test); }, stop);
  }
  const double duration_s = seconds(clock.now() - start);
  if (arguments.json) {
    print_json(figures, workers.threads(), duration_s);
  } else {
    print_table(figures, duration_s);
  }
  require_all(figures);
}

}  // namespace

void add_bench_stability(CLI::App& bench, const std::vector<std::string>& scenes,
                         const SceneFinder& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<StabilityArguments>();
  CLI::App* command = bench.add_subcommand(
      "stability", "Stress tests of numerical stability: furnaces, known answers, leaks, bits");
  CLI::Option* quick =
      command->add_flag("--quick", arguments->quick, "Run smaller tests, in a minute or two");
  command
      ->add_flag("--full", arguments->full,
                 "Run larger tests: 10^9 paths over the scenes, for hours")
      ->excludes(quick);
  command->add_option("--only", arguments->only,
                      "Run only the stress tests whose name contains this");
  add_threads_option(*command, arguments->threads);
  command->add_option("--paths", arguments->scene_paths,
                      "Number of paths over the scenes (default: by --quick and --full)");
  command
      ->add_option("--seed", arguments->scene_seed,
                   "Seed of these paths: many can be traced in several runs, each with its own "
                   "seed")
      ->check(CLI::Range(std::uint32_t{0}, std::numeric_limits<std::uint32_t>::max()));
  add_json_option(*command, arguments->json);
  command->footer("Example: foveola bench stability --quick");
  command->callback([arguments, scenes, find_scene, stop] {
    run_stability(*arguments, found(scenes, find_scene), stop);
  });
}

}  // namespace foveola
