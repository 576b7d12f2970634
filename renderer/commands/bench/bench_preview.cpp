#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "renderer/base/clock.h"
#include "renderer/base/text/print.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/bench/bench_commands.h"
#include "renderer/commands/bench_facts.h"
#include "renderer/commands/look_options.h"
#include "renderer/commands/preview/preview_report.h"
#include "renderer/commands/scene_file_options.h"
#include "renderer/gaze/gaze_source.h"
#include "renderer/preview/live_frames.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {
namespace {

using Json = nlohmann::ordered_json;

struct PreviewArguments {
  std::string scene;
  RenderSettings settings{.method = "fv", .progressive = {.film_size = live_film_size}};
  std::string view;
  std::string tracker = "fove0";
  std::string display = "fove0";
  std::optional<double> rate_hz;
  int frames = 700;
  int restart_every = 100;
  bool json = false;
};

RenderSettings settings_of(const PreviewArguments& arguments) {
  RenderSettings settings = arguments.settings;
  if (!arguments.view.empty()) {
    settings.view = parse_size("--view", arguments.view);
  }
  return settings;
}

/// A run without frames yet.
PreviewRun run_of(const PreviewArguments& arguments, const RenderSettings& settings) {
  PreviewRun run{.frames = {},
                 .tracker = read_tracker_profile(arguments.tracker),
                 .display = read_display_profile(arguments.display)};
  run.refresh_rate_hz = arguments.rate_hz.value_or(run.display.refresh_rate_hz);
  run.is_resampled = settings.view.has_value();
  run.frames.reserve(static_cast<std::size_t>(arguments.frames));
  return run;
}

/// Without a window: frames end when they are traced or, with a view, resampled to it.
FrameOutput output_without_window(const RenderSettings& settings) {
  const bool is_resampled = settings.view.has_value();
  return {.resample =
              [is_resampled](Preview& preview) {
                if (is_resampled) {
                  preview.present();
                }
              },
          .present = [] { return std::nullopt; }};
}

PreviewRun run_frames(const PreviewArguments& arguments, const SceneSource& source,
                      const std::stop_token& stop) {
  const RenderSettings settings = settings_of(arguments);
  PreviewRun run = run_of(arguments, settings);
  const Workers workers(settings.threads);
  const LoadedScene loaded =
      load_or_exit(stop, [&] { return LoadedScene(source, workers, settings.scene); });
  print_warnings(loaded.warnings);
  run.threads = workers.threads();
  const SteadyClock clock;
  const auto eye = open_eye_tracker(run.tracker, screen_of(run.display), clock);
  ScriptedHeadTracker head({{.time = Nanoseconds(0), .heading = loaded.camera.heading}});
  Preview preview(loaded.tracer,
                  {.render = loaded.rendered_with(settings.progressive),
                   .view_size = settings.view.value_or(default_view_size),
                   .exposure_stops = source.exposure_stops.value_or(0.0)},
                  *eye, head, workers);
  const std::uint32_t seed = settings.progressive.trace.seed;
  preview.restart(settings.method, seed);
  const auto wait_until = [](Nanoseconds time) {
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(time));
  };
  LiveFrames live(preview, clock, RefreshEstimator(run.refresh_rate_hz), wait_until,
                  output_without_window(settings));
  Progress progress("frames");
  for (int i = 0; i < arguments.frames && !stop.stop_requested(); ++i) {
    if (i > 0 && i % arguments.restart_every == 0) {
      preview.restart(settings.method, seed + static_cast<std::uint32_t>(i));
    }
    run.frames.push_back(live.next());
    progress.update(static_cast<double>(i + 1) / arguments.frames);
  }
  return run;
}

/// The run's figures, with its request and machine.
Json json_of(const PreviewRun& run, const PreviewArguments& arguments) {
  Json json = bench_facts();
  json.update({{"scene", arguments.scene},
               {"method", arguments.settings.method},
               {"size", size_text(arguments.settings.progressive.film_size)},
               {"view", arguments.view}});
  json.update(preview_json(run));
  return json;
}

void run_bench(const PreviewArguments& arguments, const SceneFinder& find_scene,
               const std::stop_token& stop) {
  const PreviewRun run = run_frames(arguments, find_scene(arguments.scene), stop);
  if (run.frames.empty()) {
    return;
  }
  if (arguments.json) {
    print_text("{}\n", json_of(run, arguments).dump(2));
  } else {
    print_text("{}", preview_text(run));
  }
}

}  // namespace

void add_bench_preview(CLI::App& bench, const SceneFinder& find_scene,
                       const std::stop_token& stop) {
  const auto arguments = std::make_shared<PreviewArguments>();
  CLI::App* command = bench.add_subcommand(
      "preview",
      "Measure without a window whether a live preview's frames are in time, and the latency from "
      "the eye to the display's light");
  add_scene_option(*command, arguments->scene);
  command->add_option("--method", arguments->settings.method, "The method, as render's --method");
  add_film_size_option(*command, arguments->settings.progressive.film_size);
  command->add_option("--view", arguments->view,
                      "Resample every frame to a view of this size in pixels, WIDTHxHEIGHT "
                      "(default: do not; in a window the graphics card does it)");
  command->add_option("--tracker", arguments->tracker, "The tracker: a profile's name or file");
  command->add_option("--display", arguments->display, "The display: a profile's name or file");
  command
      ->add_option("--rate", arguments->rate_hz,
                   "The display's refresh rate in Hz (default: by its profile)")
      ->check(CLI::Range(1.0, 1000.0));
  command->add_option("--frames", arguments->frames, "Number of frames")
      ->check(CLI::Range(1, 10'000'000));
  command
      ->add_option("--restart-every", arguments->restart_every,
                   "Restart the picture after this many frames")
      ->check(CLI::Range(1, 10'000'000));
  add_threads_option(*command, arguments->settings.threads);
  add_json_option(*command, arguments->json);
  command->footer("Example: foveola bench preview arcade --frames 10000");
  command->callback([arguments, find = with_scene_file_options(*command, find_scene), stop] {
    run_bench(*arguments, find, stop);
  });
}

}  // namespace foveola
