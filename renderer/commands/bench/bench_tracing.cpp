#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "renderer/base/build_info.h"
#include "renderer/base/clock.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/bench/bench_commands.h"
#include "renderer/commands/bench/tracing_figures.h"
#include "renderer/commands/bench_facts.h"
#include "renderer/commands/look_options.h"
#include "renderer/commands/scene_file_options.h"
#include "renderer/progressive/headless_render.h"
#include "renderer/trace/rays/embree_alone.h"

namespace foveola {
namespace {

/// Number of paths sampled, traced and filmed at a time, as in a render's batches.
constexpr std::uint64_t pass_points = 1 << 16;

struct TracingArguments {
  std::string scene;
  RenderSettings settings{.progressive = {.trace = {.seed = 1}},
                          .budget = {.samples = std::uint64_t{1} << 18}};
  std::string camera;
  std::vector<int> threads;
  int repetitions = 7;
  bool no_fast_path = false;
  bool json = false;
};

/// Embree's times for the rays of one kind.
struct EmbreeRepetitions {
  std::vector<std::vector<double>> seconds;  ///< by entry point, then by repetition
  std::vector<std::string> entry_points;

  void add(const std::vector<EmbreeTime>& times) {
    seconds.resize(times.size());
    entry_points.resize(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      entry_points[i] = times[i].entry_point;
      seconds[i].push_back(times[i].seconds);
    }
  }
};

/// The entry point with the smallest median.
std::size_t fastest_of(const EmbreeRepetitions& repetitions) {
  std::size_t fastest = 0;
  for (std::size_t i = 1; i < repetitions.seconds.size(); ++i) {
    if (median_of(repetitions.seconds[i]).value < median_of(repetitions.seconds[fastest]).value) {
      fastest = i;
    }
  }
  return fastest;
}

EmbreeFigure figure_of(const char* kind, const EmbreeRepetitions& repetitions) {
  EmbreeFigure figure{.kind = kind, .entry_point = "", .all = {}};
  for (std::size_t i = 0; i < repetitions.entry_points.size(); ++i) {
    figure.all.emplace_back(repetitions.entry_points[i], median_of(repetitions.seconds[i]));
  }
  const auto& [entry_point, time_s] = figure.all[fastest_of(repetitions)];
  figure.entry_point = entry_point;
  figure.seconds = time_s.value;
  return figure;
}

/// The seconds of each repetition for all kinds of rays, each kind by its fastest entry point.
template <std::size_t kinds>
std::vector<double> embree_seconds(const std::array<EmbreeRepetitions, kinds>& embree) {
  std::vector<double> sums;
  for (const EmbreeRepetitions& repetitions : embree) {
    const std::vector<double>& fastest = repetitions.seconds[fastest_of(repetitions)];
    sums.resize(fastest.size());
    std::transform(sums.begin(), sums.end(), fastest.begin(), sums.begin(), std::plus<>());
  }
  return sums;
}

/// The quotients, element by element.
std::vector<double> ratios(const std::vector<double>& numerators,
                           const std::vector<double>& denominators) {
  std::vector<double> result(numerators.size());
  std::transform(numerators.begin(), numerators.end(), denominators.begin(), result.begin(),
                 std::divides<>());
  return result;
}

/// One render's paths, for repetitions.
class RepeatedRender {
 public:
  RepeatedRender(const LoadedScene& loaded, const RenderSettings& settings, const Workers& workers)
      : loaded_(loaded),
        settings_(settings),
        workers_(workers),
        sampler_(make_view_sampler(settings.method)) {
    sampler_->aim({.viewport = Viewport(loaded.camera.heading, settings.field_of_view),
                   .gaze = direction_from(gaze_of(settings, loaded))});
  }

  /// Renders once, from the first sample to the film. Returns the seconds.
  double render(RayCounts& rays) const {
    ProgressiveRender render = begin();
    rays = {};
    const SteadyClock clock;
    const Nanoseconds start = clock.now();
    while (render.points_drawn() < settings_.budget.samples) {
      const TracedSamples traced = render.advance(*sampler_, next_pass(render.points_drawn()));
      for (const RayKind& kind : ray_kinds) {
        rays.*kind.count += traced.rays.*kind.count;
      }
    }
    return seconds(clock.now() - start);
  }

  /// All rays of that render.
  RayLog log_rays() const {
    RayLog log;
    ProgressiveRender render = begin();
    while (render.points_drawn() < settings_.budget.samples) {
      const std::vector<SampleJob> jobs =
          render.pass_over(*sampler_, next_pass(render.points_drawn()));
      const RayLog more =
          loaded_.tracer.log_rays(loaded_.camera.position, jobs, render.trace_settings());
      for (const RayKind& kind : ray_kinds) {
        std::vector<Ray>& rays = log.*kind.rays;
        rays.insert(rays.end(), (more.*kind.rays).begin(), (more.*kind.rays).end());
      }
    }
    return log;
  }

 private:
  ProgressiveRender begin() const {
    ProgressiveRender render(loaded_.tracer, loaded_.rendered_with(settings_.progressive),
                             workers_);
    render.begin_pattern(settings_.progressive.trace.seed);
    return render;
  }

  std::uint64_t next_pass(std::uint64_t drawn) const {
    return std::min(pass_points, settings_.budget.samples - drawn);
  }

  const LoadedScene& loaded_;
  const RenderSettings& settings_;
  const Workers& workers_;
  std::unique_ptr<ViewSampler> sampler_;
};

/// Full renders and Embree alone alternate, so that a busy machine slows both.
TracingFigures measure(const SceneSource& source, const RenderSettings& settings, int repetitions,
                       bool with_general, const std::stop_token& stop) {
  const Workers workers(settings.threads);
  const LoadedScene loaded =
      load_or_exit(stop, [&] { return LoadedScene(source, workers, settings.scene); });
  const RepeatedRender usual(loaded, settings, workers);
  RenderSettings general_settings = settings;
  general_settings.progressive.trace.uses_general_path = true;
  const RepeatedRender general(loaded, general_settings, workers);
  const RayLog log = usual.log_rays();
  TracingFigures figures{
      .threads = workers.threads(), .warnings = loaded.warnings, .rays = {}, .embree = {}};
  std::vector<double> render_s;
  std::vector<double> general_s;
  std::array<EmbreeRepetitions, ray_kinds.size()> embree;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    render_s.push_back(usual.render(figures.rays));
    if (with_general) {
      RayCounts rays;
      general_s.push_back(general.render(rays));
    }
    for (std::size_t i = 0; i < ray_kinds.size(); ++i) {
      embree[i].add(time_embree(loaded.tracer.ray_scene(), log.*ray_kinds[i].rays,
                                ray_kinds[i].query, workers));
    }
  }
  for (std::size_t i = 0; i < ray_kinds.size(); ++i) {
    figures.embree.push_back(figure_of(ray_kinds[i].name, embree[i]));
  }
  const std::vector<double> embree_s = embree_seconds(embree);
  figures.seconds = median_of(render_s);
  figures.ratio_to_embree = median_of(ratios(render_s, embree_s));
  figures.embree_seconds = median_of(embree_s);
  if (with_general) {
    figures.general.emplace().gain = median_of(ratios(general_s, render_s));
    figures.general->seconds = median_of(general_s);
  }
  return figures;
}

void print_json(const std::vector<TracingFigures>& runs, const TracingArguments& arguments,
                const RenderSettings& settings) {
  const nlohmann::ordered_json list(transformed(runs, [&](const TracingFigures& figures) {
    return json_of(figures, settings.budget.samples);
  }));
  nlohmann::ordered_json json = bench_facts();
  json.update({{"scene", arguments.scene},
               {"method", settings.method},
               {"width", settings.progressive.film_size.x},
               {"height", settings.progressive.film_size.y},
               {"max_depth", settings.progressive.trace.max_depth},
               {"paths", settings.budget.samples},
               {"repetitions", arguments.repetitions},
               {"runs", list}});
  print_text("{}\n", json.dump(2));
}

RenderSettings settings_from(const TracingArguments& arguments) {
  RenderSettings settings = arguments.settings;
  if (!arguments.camera.empty()) {
    settings.scene.camera = parse_vec3("--camera", arguments.camera);
  }
  return settings;
}

/// Default numbers of threads: one, and all cores.
std::vector<int> default_threads() {
  const int cores = usable_cores();
  return cores == 1 ? std::vector{1} : std::vector{1, cores};
}

void run(const TracingArguments& arguments, const SceneFinder& find_scene,
         const std::stop_token& stop) {
  const SceneSource source = find_scene(arguments.scene);
  RenderSettings settings = settings_from(arguments);
  std::vector<TracingFigures> runs;
  for (const int threads : arguments.threads.empty() ? default_threads() : arguments.threads) {
    settings.threads = threads;
    runs.push_back(measure(source, settings, arguments.repetitions, arguments.no_fast_path, stop));
  }
  print_warnings(runs.front().warnings);
  if (arguments.json) {
    print_json(runs, arguments, settings);
    return;
  }
  print_text("{}\n", build_info().ray_tracer);
  print_table(runs, settings.budget.samples);
}

}  // namespace

void add_bench_tracing(CLI::App& bench, const SceneFinder& find_scene,
                       const std::stop_token& stop) {
  const auto arguments = std::make_shared<TracingArguments>();
  CLI::App* command = bench.add_subcommand(
      "tracing", "Measure the time per path, compared with Embree alone for the same rays");
  add_scene_option(*command, arguments->scene);
  command->add_option("--method", arguments->settings.method, "The method, as render's --method");
  add_film_size_option(*command, arguments->settings.progressive.film_size);
  command->add_option("--camera", arguments->camera,
                      "Camera position: x,y,z in metres (default: as in render)");
  command
      ->add_option("--threads", arguments->threads,
                   "Numbers of threads, each measured (default: 1 and all cores)")
      ->delimiter(',')
      ->check(CLI::Range(1, 1024));
  command->add_option("--paths", arguments->settings.budget.samples, "Paths of each repetition")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 22));
  command
      ->add_option("--repetitions", arguments->repetitions,
                   "Number of repetitions; their median is reported")
      ->check(CLI::Range(1, 1000));
  add_max_depth_option(*command, arguments->settings.progressive.trace.max_depth);
  command->add_flag("--no-fast-path", arguments->no_fast_path,
                    "Also measure the general path, and the fast path's gain over it");
  add_json_option(*command, arguments->json);
  command->footer("Example: foveola bench tracing arcade --threads 1,2 --json");
  command->callback([arguments, stop, find = with_scene_file_options(*command, find_scene)] {
    run(*arguments, find, stop);
  });
}

}  // namespace foveola
