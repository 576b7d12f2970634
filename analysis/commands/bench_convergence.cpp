#include "analysis/commands/bench_convergence.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/convergence/convergence_figures.h"
#include "analysis/convergence/convergence_files.h"
#include "analysis/convergence/measurement.h"
#include "analysis/publication/output_folder.h"
#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/progress.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/former_option.h"
#include "renderer/commands/scene_file_options.h"
#include "renderer/commands/warnings.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/loaded_scene.h"
#include "study/stage/scene_stage.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

struct ConvergenceArguments {
  std::vector<std::string> scenes;
  std::string methods = "od,vp,fv,hybrid:0.9*fv+0.1*od";
  std::vector<std::string> options = {"independent"};
  fs::path folder;
  std::optional<std::string> size;
  std::optional<int> samples_per_pixel;
  std::optional<int> repetitions;
  int max_depth = TraceSettings{}.max_depth;
  int gazes = 1;
  int threads = 0;
  bool quick = false;
  bool json = false;
};

/// The limit of `--quick`, for all scenes together: references and crops fill the two minutes.
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
  plan.max_depth = arguments.max_depth;
  if (arguments.repetitions) {
    plan.least_repetitions = *arguments.repetitions;
    plan.most_repetitions = *arguments.repetitions;
  }
  return plan;
}

/// A progress line for each thing that is done.
class ProgressLines {
 public:
  void update(const std::string& what, double fraction) {
    if (what != what_) {
      line_.reset();
      line_.emplace(what);
      what_ = what;
    }
    line_->update(fraction);
  }

 private:
  std::string what_;
  std::optional<Progress> line_;
};

struct Results {
  std::vector<GazeMeasurement> measurements;
  std::vector<RgbImage> crops;  ///< one strip for each measurement
  std::vector<double> exposure_stops;
};

/// Measures gaze after gaze, and shares out the time that is left.
class ConvergenceBench {
 public:
  ConvergenceBench(const ConvergenceArguments& arguments, const SceneFinder& find_scene,
                   std::stop_token stop)
      : arguments_(arguments),
        plan_(plan_of(arguments)),
        stop_(std::move(stop)),
        gazes_left_(arguments.scenes.size() * static_cast<std::size_t>(arguments.gazes)) {
    for (const std::string& name : arguments.scenes) {
      sources_.push_back(find_scene(name));
    }
    start_ = clock_.now();
  }

  const ConvergencePlan& plan() const { return plan_; }

  Results run() {
    for (const SceneSource& source : sources_) {
      run_scene(source);
    }
    return std::move(results_);
  }

 private:
  void run_scene(const SceneSource& source) {
    if (stop_.stop_requested()) {
      return;
    }
    const Workers workers(arguments_.threads);
    const LoadedScene loaded(source, workers);
    print_warnings(loaded.warnings);
    Subject subject{.loaded = loaded, .key = study::scene_key(loaded)};
    subject.add_tracers_for(plan_.configurations, workers);
    for (int i = 0; i < arguments_.gazes && !stop_.stop_requested(); ++i) {
      const double turn_rad = 2.0 * std::numbers::pi * i / arguments_.gazes;
      // Turned into [-pi, pi], as directions have their azimuths.
      run_gaze(subject, workers,
               azimuth_elevation(
                   direction_from({.azimuth_rad = loaded.camera.heading.azimuth_rad + turn_rad})));
    }
  }

  void run_gaze(const Subject& subject, const Workers& workers, const AzimuthElevation& gaze) {
    ProgressLines lines;
    const ReportProgress progress = [&lines](const std::string& what, double fraction) {
      lines.update(what, fraction);
    };
    try {
      const GazeBench bench(subject, plan_, gaze, workers, cache_folder() / "references", progress,
                            stop_);
      GazeMeasurement measurement = bench.measure(limit_s(), progress);
      if (!measurement.repetitions.empty()) {
        results_.measurements.push_back(std::move(measurement));
        results_.crops.push_back(bench.crops());
        results_.exposure_stops.push_back(subject.loaded.source.exposure_stops.value_or(0.0));
      }
    } catch (const Error&) {
      // A reference that was stopped takes nothing from what was measured before.
      if (!stop_.stop_requested()) {
        throw;
      }
    }
    --gazes_left_;
  }

  /// The time that the repetitions of the next gaze may take; 0: no limit.
  double limit_s() const {
    constexpr double least_s = 1.0;
    if (!arguments_.quick) {
      return 0.0;
    }
    const double left_s = quick_limit_s - seconds(clock_.now() - start_);
    return std::max(least_s, left_s / static_cast<double>(gazes_left_));
  }

  const ConvergenceArguments& arguments_;
  ConvergencePlan plan_;
  std::stop_token stop_;
  SteadyClock clock_;
  Nanoseconds start_{0};
  std::vector<SceneSource> sources_;
  std::size_t gazes_left_;
  Results results_;
};

/// Everything is computed before anything is written.
void write_results(const fs::path& folder, const Results& results, const ConvergenceTables& tables,
                   const std::string& json) {
  std::vector<TextFile> files = convergence_csv(results.measurements, tables);
  for (const Figure& figure : draw_convergence(results.measurements)) {
    files.push_back({figure.name + ".svg", figure.svg});
  }
  files.push_back({"convergence.json", json});
  make_output_folder(folder);
  for (std::size_t i = 0; i < results.crops.size(); ++i) {
    write_image(folder / fmt::format("crops-{}.png", i + 1), results.crops[i],
                results.exposure_stops[i]);
  }
  for (const TextFile& file : files) {
    write_file(folder / file.name, file.content);
  }
}

void run(const ConvergenceArguments& arguments, const SceneFinder& find_scene,
         const std::stop_token& stop) {
  check_output_folder(arguments.folder);
  ConvergenceBench bench(arguments, find_scene, stop);
  const Results results = bench.run();
  if (results.measurements.empty()) {
    throw Error(arguments.folder.string(), "is not written: no repetition was finished",
                "let it run longer, or try --quick");
  }
  const ConvergenceTables tables = tabulate(results.measurements);
  const std::string json = convergence_json(bench.plan(), results.measurements, tables);
  write_results(arguments.folder, results, tables, json);
  if (arguments.json) {
    fmt::print("{}", json);
  } else {
    fmt::print("{}Tables, figures and crops: {}\n", convergence_summary(tables),
               arguments.folder.string());
  }
}

}  // namespace

void add_bench_convergence(CLI::App& bench, const SceneFinder& find_scene,
                           const std::stop_token& stop) {
  const auto arguments = std::make_shared<ConvergenceArguments>();
  CLI::App* command = bench.add_subcommand(
      "convergence", "Measure how much faster each method reaches the error of the first one");
  command->add_option("SCENE", arguments->scenes, "Scenes' names, or .glb, .gltf or .obj files")
      ->required();
  command
      ->add_option("-o,--output", arguments->folder,
                   "A folder for tables (CSV, JSON), figures (SVG) and crops (PNG); made if its "
                   "parent exists")
      ->required();
  command
      ->add_option(
          "--methods", arguments->methods,
          "Methods as render's --method, separated by commas; the others are compared with "
          "the first, the baseline")
      ->capture_default_str();
  CLI::Option* const options =
      command
          ->add_option(
              "--options", arguments->options,
              "What to change of the first method, each in a configuration of its own: "
              "independent (random numbers instead of low-discrepancy sequences), clamp "
              "(samples are cut at a radiance of 10), adaptive (sampling as render's "
              "--adaptive 0.01), no-fast-path (the general path alone), no-hierarchy (lights "
              "drawn by their power alone), no-learning (nothing learned of which lights reach "
              "where), uniform-lights (each light as likely as any other), "
              "area-lights (points uniform in the area of near triangles too), cosine-sky "
              "(directions to the environment by the surface's cosine alone), no-mis (light "
              "samples alone, without multiple importance sampling), no-roulette (dim paths are "
              "not ended), plain-paths (what a plain path tracer of 2017 would do: independent and "
              "the last five together), plain-paths-mis (the same but for no-mis), "
              "plain-paths-mis-clamp (and light samples cut at 3); or none")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->capture_default_str();
  accept_former_values(*options, {{"spare-done", "adaptive"}, {"no-skip", "no-fast-path"}});
  command
      ->add_option("--gazes", arguments->gazes,
                   "Gaze points around the horizon, the first ahead of the scene's camera")
      ->check(CLI::Range(1, 360))
      ->capture_default_str();
  command->add_option("--size", arguments->size,
                      "Size of the film in pixels (default: 1024x512; quick: 192x96)");
  command
      ->add_option("--spp", arguments->samples_per_pixel,
                   "Samples of each render per pixel of the film (default: 32; quick: 16)")
      ->check(CLI::Range(16, 1 << 16));
  command->add_option("--max-depth", arguments->max_depth, "The most surface vertices of a path")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  CLI::Option* const repetitions =
      command
          ->add_option("--repetitions", arguments->repetitions,
                       "Renders of each method with other seeds (default: 4; quick: 3 to 8)")
          ->check(CLI::Range(2, 1000));
  accept_former_name(*command, *repetitions, "--rounds");
  command->add_option("--threads", arguments->threads, "Number of threads; 0: one for each core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->add_flag("--quick", arguments->quick,
                    "Measure a smaller and coarser plan, in about two minutes");
  command->add_flag("--json", arguments->json, "Print the tables as JSON");
  command->footer("Example: foveola bench convergence arcade church -o convergence --quick");
  command->callback([arguments, find = with_scene_file_options(*command, find_scene), stop] {
    run(*arguments, find, stop);
  });
}

}  // namespace foveola::analysis
