#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/commands/commands.h"
#include "analysis/commands/convergence_run.h"
#include "analysis/convergence/convergence_figures.h"
#include "analysis/convergence/convergence_files.h"
#include "analysis/convergence/pooled_runs.h"
#include "analysis/publication/exports/output_folder.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/work/parallel.h"
#include "renderer/base/work/shard.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/bench_facts.h"
#include "renderer/commands/scene_file_options.h"
#include "renderer/image/image_file.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

struct ConvergenceArguments {
  std::vector<std::string> scenes;
  std::string methods = "od,vp,fv,hybrid:0.9*fv+0.1*od";
  std::vector<std::string> options = {"independent"};
  std::vector<std::string> from;
  fs::path output;
  std::string shard;
  std::optional<std::string> size;
  std::optional<int> samples_per_pixel;
  std::optional<int> repetitions;
  std::optional<int> view_size;
  int max_depth = TraceSettings{}.max_depth;
  int gazes = 1;
  std::uint32_t seed = 0;
  int threads = 0;
  bool quick = false;
  bool references = false;
  bool json = false;
};

/// Time limit of `--quick`, for all scenes together: references and crops fill the two minutes.
constexpr double quick_limit_s = 100.0;

ConvergencePlan quick_plan() {
  ConvergencePlan plan;
  plan.size = {192, 96};
  plan.samples_per_pixel = 16;
  plan.least_repetitions = 3;
  plan.most_repetitions = 8;
  plan.view_size = 160;
  plan.reference_samples_per_pixel = 32;
  plan.reference_foveated_per_pixel = 2;
  plan.crop_seconds = 0.5;
  return plan;
}

ConvergencePlan plan_of(const ConvergenceArguments& arguments) {
  ConvergencePlan plan = arguments.quick ? quick_plan() : ConvergencePlan{};
  const bool has_options = arguments.options != std::vector<std::string>{"none"};
  plan.configurations =
      make_configurations(split_methods(arguments.methods),
                          has_options ? arguments.options : std::vector<std::string>{});
  if (arguments.size) {
    plan.size = parse_size("--size", *arguments.size);
  }
  plan.samples_per_pixel = arguments.samples_per_pixel.value_or(plan.samples_per_pixel);
  plan.view_size = arguments.view_size.value_or(plan.view_size);
  plan.max_depth = arguments.max_depth;
  plan.seed = arguments.seed;
  if (arguments.repetitions) {
    plan.least_repetitions = *arguments.repetitions;
    plan.most_repetitions = *arguments.repetitions;
  }
  return plan;
}

ConvergenceRun run_of(const ConvergenceArguments& arguments, const SceneFinder& find_scene) {
  ConvergenceRun run{.plan = plan_of(arguments),
                     .gazes = arguments.gazes,
                     .threads = arguments.threads,
                     .limit_s = arguments.quick ? quick_limit_s : 0.0};
  for (const std::string& name : arguments.scenes) {
    run.scenes.push_back(find_scene(name));
  }
  return run;
}

void write_results(const ConvergenceArguments& arguments, const nlohmann::ordered_json& facts,
                   const MeasuredGazes& results) {
  const ConvergenceTables tables = tabulate(results.measurements);
  const std::string json = convergence_json(facts, results.measurements, tables);
  std::vector<TextFile> files = convergence_csv(results.measurements, tables);
  files.push_back({"convergence.json", json});
  const fs::path& folder = arguments.output;
  make_output_folder(folder);
  for (std::size_t i = 0; i < results.crops.size(); ++i) {
    write_image(folder / fmt::format("crops-{}.png", i + 1), results.crops[i],
                results.exposure_stops[i]);
  }
  for (const TextFile& file : files) {
    write_file(folder / file.name, file.content);
  }
  // Figures come last, so that a missing gnuplot does not lose hours of measurement.
  for (const Figure& figure : draw_convergence(results.measurements)) {
    write_file(folder / (figure.name + ".svg"), figure.svg);
  }
  if (arguments.json) {
    print_text("{}", json);
  } else {
    print_text("{}Tables and figures: {}\n", convergence_summary(tables), folder.string());
  }
}

void measure(const ConvergenceArguments& arguments, const SceneFinder& find_scene,
             const std::stop_token& stop) {
  const ConvergenceRun run = run_of(arguments, find_scene);
  const MeasuredGazes results = measure_all(run, stop);
  if (results.measurements.empty()) {
    throw Error(arguments.output.string(), "was not written: no repetition was finished",
                "allow more time, or try --quick");
  }
  nlohmann::ordered_json facts = bench_facts();
  facts["threads"] = Workers(run.threads).threads();
  facts["gazes"] = run.gazes;
  facts.update(plan_facts(run.plan));
  write_results(arguments, facts, results);
}

void pool(const ConvergenceArguments& arguments) {
  PooledRuns pooled = pool_runs({arguments.from.begin(), arguments.from.end()});
  write_results(arguments, pooled.facts, {.measurements = std::move(pooled.measurements)});
}

void run_references(const ConvergenceArguments& arguments, const SceneFinder& find_scene,
                    const std::stop_token& stop) {
  const Shard shard = arguments.shard.empty() ? Shard{} : parse_shard("--shard", arguments.shard);
  const std::int64_t halves = render_references(run_of(arguments, find_scene), shard, stop);
  const std::string folder = (cache_folder() / "references").string();
  if (arguments.json) {
    const nlohmann::json json = {{"cache", folder}, {"halves", halves}};
    print_text("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print_text(
        "{}: has {}\n", folder,
        halves == 1 ? "1 half of a reference" : fmt::format("{} halves of references", halves));
  }
}

/// Throws UsageError for options of measuring only.
void require_pooling_alone(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() > 0 && name != "--from" && name != "--output" && name != "--json") {
      throw UsageError("--from", fmt::format("cannot be combined with {}", name),
                       "remove one of them");
    }
  }
}

void run(const ConvergenceArguments& arguments, const SceneFinder& find_scene,
         const std::stop_token& stop) {
  if (arguments.scenes.empty() && arguments.from.empty()) {
    throw UsageError("SCENE", "is required", "name at least one scene");
  }
  if (arguments.references) {
    run_references(arguments, find_scene, stop);
    return;
  }
  if (arguments.output.empty()) {
    throw UsageError("--output", "is required", "name a folder");
  }
  check_output_folder(arguments.output);
  if (arguments.from.empty()) {
    measure(arguments, find_scene, stop);
  } else {
    pool(arguments);
  }
}

}  // namespace

void add_bench_convergence(CLI::App& bench, const SceneFinder& find_scene,
                           const std::stop_token& stop) {
  const auto arguments = std::make_shared<ConvergenceArguments>();
  CLI::App* command = bench.add_subcommand(
      "convergence", "Measure how much faster each method reaches the error of the first one");
  command->add_option("SCENE", arguments->scenes, "Scenes' names, or .glb, .gltf or .obj files");
  CLI::Option* const output = command->add_option(
      "-o,--output", arguments->output,
      "A folder for tables (CSV, JSON), figures (SVG) and crops (PNG), made if its parent exists");
  command->add_option(
      "--methods", arguments->methods,
      "Methods as of render --method, separated by commas; the others are compared with "
      "the first, the baseline");
  command
      ->add_option("--options", arguments->options,
                   "Changes of the first method, each in a configuration of its own: "
                   "independent (random numbers instead of low-discrepancy sequences), clamp "
                   "(samples are clamped to a radiance of 10), adaptive (sampling as with render "
                   "--adaptive 0.01), no-fast-path (the general path only), no-hierarchy (lights "
                   "drawn by power only), no-learning (without learning which lights reach "
                   "where), uniform-lights (equal probability of all lights), "
                   "area-lights (points uniform in the area of near triangles too), cosine-sky "
                   "(directions to the environment by the surface's cosine only), no-mis (light "
                   "samples only, without multiple importance sampling), no-roulette (no Russian "
                   "roulette), plain-paths (a plain path tracer of 2017: independent and "
                   "the last five together), plain-paths-mis (the same except no-mis), "
                   "plain-paths-mis-clamp (and light samples clamped to 3); or none")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--gazes", arguments->gazes,
                   "Gaze points around the horizon, the first ahead of the scene's camera")
      ->check(CLI::Range(1, 360));
  command->add_option("--size", arguments->size,
                      "Size of the film in pixels (default: 1024x512; quick: 192x96)");
  command
      ->add_option("--spp", arguments->samples_per_pixel,
                   "Samples of each render per pixel of the film (default: 32; quick: 16)")
      ->check(CLI::Range(16, 1 << 16));
  command
      ->add_option("--view-size", arguments->view_size,
                   fmt::format("Pixels along each side of the display that FLIP is measured on "
                               "(default: {}; quick: {})",
                               ConvergencePlan{}.view_size, quick_plan().view_size))
      ->check(CLI::Range(16, 8192));
  add_max_depth_option(*command, arguments->max_depth);
  command
      ->add_option("--repetitions", arguments->repetitions,
                   "Renders of each method with different seeds (default: 4; quick: 3 to 8)")
      ->check(CLI::Range(2U, max_repetitions));
  command
      ->add_option("--seed", arguments->seed,
                   "Seed of the renders: runs with different seeds can be pooled by --from")
      ->check(CLI::Range(0U, max_seed));
  add_threads_option(*command, arguments->threads);
  command->add_flag("--quick", arguments->quick,
                    "Measure a smaller and coarser plan, in about two minutes");
  CLI::Option* const references =
      command
          ->add_flag("--references", arguments->references,
                     "Only render those references for these options that the cache "
                     "need")
          ->excludes(output);
  command
      ->add_option("--shard", arguments->shard,
                   "With --references, the Kth of N parts of them, as K/N")
      ->needs(references);
  command->add_option("--from", arguments->from,
                      "Pool the runs in these folders, which differ only in scenes or --seed, "
                      "instead of measuring");
  command->add_flag("--json", arguments->json, "Print the tables as JSON");
  command->footer("Example: foveola bench convergence arcade church -o convergence --quick");
  command->callback(
      [arguments, command, find = with_scene_file_options(*command, find_scene), stop] {
        if (!arguments->from.empty()) {
          require_pooling_alone(*command);
        }
        run(*arguments, find, stop);
      });
}

}  // namespace foveola::analysis
