#include "renderer/commands/bench_stability.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "renderer/base/clock.h"
#include "renderer/base/cores.h"
#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/print.h"
#include "renderer/base/progress.h"
#include "renderer/commands/bench_facts.h"
#include "renderer/stability/finite_radiance.h"
#include "renderer/stability/stability.h"

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
  BenchPartArguments part;
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

/// All stress tests, or those whose name has `only` in it.
std::vector<StabilityCheck> chosen_checks(const std::vector<SceneSource>& scenes,
                                          const std::string& only) {
  std::vector<StabilityCheck> checks = stability_checks(scenes);
  std::vector<std::string> names;
  for (const StabilityCheck& check : checks) {
    names.push_back(check.name);
  }
  std::erase_if(checks,
                [&](const auto& check) { return check.name.find(only) == std::string::npos; });
  if (checks.empty()) {
    throw Error("--only", fmt::format("no stress test is called {}", only),
                fmt::format("there are: {}", fmt::join(names, ", ")));
  }
  return checks;
}

/// The number of threads: at least four unless asked otherwise, also on fewer cores: bits must be
/// equal on four threads, and TBB starts no more than the first of its users allows.
int thread_count(const StabilityArguments& arguments) {
  const int cores = usable_cores();
  return arguments.threads > 0 ? arguments.threads : std::max(4, cores);
}

std::vector<SceneSource> found(const std::vector<std::string>& names,
                               const SceneFinder& find_scene) {
  std::vector<SceneSource> scenes;
  for (const std::string& name : names) {
    scenes.push_back(find_scene(name));
  }
  return scenes;
}

nlohmann::json json_of(const StabilityFigure& figure) {
  nlohmann::json measured = nullptr;  // JSON has no NaN
  if (std::isfinite(figure.measured)) {
    measured = figure.measured;
  }
  return {{"name", figure.name}, {"measured", measured},      {"bound", figure.bound},
          {"unit", figure.unit}, {"passes", figure.passes()}, {"details", figure.details}};
}

/// about: what is known of the run beside its figures.
void print_json(const std::vector<StabilityFigure>& figures, nlohmann::json about) {
  nlohmann::json list = nlohmann::json::array();
  for (const StabilityFigure& figure : figures) {
    list.push_back(json_of(figure));
  }
  about.update(nlohmann::json(bench_facts()));
  about["figures"] = std::move(list);
  print_text("{}\n", about.dump(2));
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
  const auto failures = std::count_if(figures.begin(), figures.end(),
                                      [](const auto& figure) { return !figure.passes(); });
  if (failures > 0) {
    throw Error("bench stability",
                fmt::format("{} of {} figures are not met", failures, figures.size()),
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
    print_json(figures, {{"threads", workers.threads()}, {"seconds", measured_once(duration_s)}});
  } else {
    print_table(figures, duration_s);
  }
  require_all(figures);
}

// --- Parts ---

constexpr std::uint64_t most_paths = std::uint64_t{1} << 53;

void require_finite_radiance_alone(const std::string& only) {
  const std::vector<StabilityCheck> checks = chosen_checks({}, only);
  if (checks.size() != 1 || checks.front().name != finite_radiance_name) {
    throw UsageError("--shard", "is for the paths over the scenes alone",
                     "add --only finite; the other stress tests take minutes and have no parts");
  }
}

nlohmann::json settings_json(const StabilityEffort& effort,
                             const std::vector<SceneSource>& scenes) {
  nlohmann::json json = {{"paths", effort.scene_paths},
                         {"paths_a_round", effort.round_paths},
                         {"seed", effort.scene_seed},
                         {"scenes", nlohmann::json::array()}};
  for (const SceneSource& scene : scenes) {
    json["scenes"].push_back(scene.name);
    json[fmt::format("sha256 of {}", scene.name)] = sha256_of_file(scene.file);
  }
  return json;
}

void run_part(const StabilityArguments& arguments, const Shard& shard,
              const std::vector<SceneSource>& scenes, const std::stop_token& stop) {
  const Workers workers(thread_count(arguments));
  const StabilityEffort effort = effort_of(arguments);
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  FiniteRadiance found;
  {
    Progress progress("numerical stability");
    found = trace_rounds({.workers = workers,
                          .effort = effort,
                          .stop = stop,
                          .progress = [&](double fraction) { progress.update(fraction); }},
                         scenes, part_of(shard, finite_radiance_rounds(effort, scenes.size())));
  }
  require_finished(arguments.part.output, stop.stop_requested());
  const BenchPart part{.command = stability_command,
                       .shard = shard,
                       .settings = settings_json(effort, scenes),
                       .results = {{"paths", found.paths},
                                   {"faults", found.faults},
                                   {"first_fault", found.first_fault},
                                   {"seconds", seconds(clock.now() - start)}},
                       .file = {}};
  write_bench_part(arguments.part.output, part);
  print_written(arguments.part.output, part, arguments.json);
}

FiniteRadiance found_in(const BenchPart& part) {
  const std::uint64_t paths = whole_number(part.results.at("paths"), most_paths);
  return {.paths = paths,
          .faults = whole_number(part.results.at("faults"), paths),
          .first_fault = part.results.at("first_fault").get<std::string>()};
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
  command->add_option("--threads", arguments->threads, "Number of threads; 0: one for each core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->add_option("--paths", arguments->scene_paths,
                      "Number of paths over the scenes, instead of what --quick or --full say");
  command->add_option(
      "--seed", arguments->scene_seed,
      "Seed of these paths: many can be traced in several runs, each with its own seed");
  add_bench_part_options(*command, arguments->part);
  command->add_flag("--json", arguments->json, "Print the figures as JSON");
  command->footer("Example: foveola bench stability --quick");
  command->callback([arguments, scenes, find_scene, stop] {
    const std::optional<Shard> shard = shard_of(arguments->part);
    if (shard) {
      require_finite_radiance_alone(arguments->only);
    }
    const std::vector<SceneSource> sources = found(scenes, find_scene);
    shard ? run_part(*arguments, *shard, sources, stop) : run_stability(*arguments, sources, stop);
  });
}

void merge_stability(const std::vector<BenchPart>& parts, bool json) {
  FiniteRadiance all;
  double duration_s = 0.0;
  for (const BenchPart& part : parts) {
    all.add(read_part(part, found_in));
    duration_s += read_part(part, [](const BenchPart& read) {
      return read.results.at("seconds").template get<double>();
    });
  }
  const auto scenes = read_part(parts.front(), [](const BenchPart& read) {
    return read.settings.at("scenes").template get<std::vector<std::string>>();
  });
  const std::vector<StabilityFigure> figures = {figure_of(all, scenes)};
  if (json) {
    print_json(figures, {{"parts", parts.size()}, {"seconds", measured_once(duration_s)}});
  } else {
    print_table(figures, duration_s);
  }
  require_all(figures);
}

}  // namespace foveola
