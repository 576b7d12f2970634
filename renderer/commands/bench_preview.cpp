#include "renderer/commands/bench_preview.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/build_info.h"
#include "renderer/base/clock.h"
#include "renderer/base/progress.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/stage.h"
#include "renderer/gaze/gaze_source.h"
#include "renderer/preview/live_frames.h"

namespace foveola {
namespace {

using Json = nlohmann::ordered_json;

struct PreviewArguments {
  std::string scene;
  std::string method = "fv";
  std::string size = "4096x2048";
  std::string view;
  std::string tracker = "fove0";
  double rate_hz = 70.0;
  int frames = 700;
  int restart_every = 100;
  int threads = 0;
  bool json = false;
};

/// What the frames of a run were like.
struct PreviewRun {
  std::vector<LiveFrame> frames;
  double frame_ms = 0.0;
  int threads = 0;
};

/// Without a window: frames end when they are traced or, with a view, resampled to it.
PreviewRun run_frames(const PreviewArguments& arguments, const SceneSource& source,
                      const RenderSettings& settings, const std::stop_token& stop) {
  const Stage stage(source, settings);
  const SteadyClock clock;
  const auto eye = open_eye_tracker(read_tracker_profile(arguments.tracker),
                                    screen_of(read_display_profile("fove0")), clock);
  ScriptedHeadTracker head({{.time = Nanoseconds(0), .heading = stage.camera.heading}});
  Preview preview(stage.tracer,
                  preview_settings(settings, stage.camera.position, source.exposure_stops), *eye,
                  head, stage.workers);
  preview.restart(settings.method, settings.seed);
  const auto wait_until = [](Nanoseconds time) {
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(time));
  };
  const auto present = [&](const Preview& shown) {
    if (settings.view) {
      shown.present();
    }
  };
  LiveFrames live(preview, clock, arguments.rate_hz, wait_until, present);
  PreviewRun run{.frame_ms = 1e3 / arguments.rate_hz, .threads = stage.workers.threads()};
  Progress progress("frames");
  for (int i = 0; i < arguments.frames && !stop.stop_requested(); ++i) {
    if (i > 0 && i % arguments.restart_every == 0) {
      preview.restart(settings.method, settings.seed + static_cast<std::uint32_t>(i));
    }
    run.frames.push_back(live.next());
    progress.update(static_cast<double>(i + 1) / arguments.frames);
  }
  return run;
}

// --- Figures ---

struct Spread {
  double median = 0.0;
  double percentile_99 = 0.0;
  double largest = 0.0;
};

template <typename Of>
Spread spread(const PreviewRun& run, const Of& of) {
  std::vector<double> values;
  for (const LiveFrame& frame : run.frames) {
    values.push_back(of(frame));
  }
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {.median = at(0.5), .percentile_99 = at(0.99), .largest = at(1.0)};
}

double ms(Nanoseconds duration) { return 1e3 * seconds(duration); }

struct PreviewFigure {
  std::string name;
  Spread value;
  std::string unit;
};

std::vector<PreviewFigure> figures_of(const PreviewRun& run) {
  return {{"polling", spread(run, [](const LiveFrame& f) { return ms(f.polling); }), "ms"},
          {"tracing", spread(run, [](const LiveFrame& f) { return ms(f.tracing); }), "ms"},
          {"presenting", spread(run, [](const LiveFrame& f) { return ms(f.presenting); }), "ms"},
          {"age of the gaze used",
           spread(run, [](const LiveFrame& f) { return ms(f.report.gaze_age); }), "ms"},
          {"samples",
           spread(run, [](const LiveFrame& f) { return static_cast<double>(f.report.samples); }),
           "a frame"}};
}

std::size_t late_frames(const PreviewRun& run) {
  return static_cast<std::size_t>(
      std::count_if(run.frames.begin(), run.frames.end(),
                    [](const LiveFrame& frame) { return frame.is_late(); }));
}

/// First frames after a restart that have samples, of all first frames.
std::pair<std::size_t, std::size_t> restarts_seen(const PreviewRun& run) {
  std::pair<std::size_t, std::size_t> seen{0, 0};
  for (const LiveFrame& frame : run.frames) {
    if (frame.report.frame == 0) {
      ++seen.second;
      seen.first += frame.report.samples > 0 ? 1 : 0;
    }
  }
  return seen;
}

void print_text(const PreviewRun& run) {
  const std::size_t late = late_frames(run);
  const auto [seen, restarts] = restarts_seen(run);
  fmt::print("{} frames of {:.2f} ms on {} threads: {} late, {:.2f} % in time\n", run.frames.size(),
             run.frame_ms, run.threads, late,
             100.0 * (1.0 - static_cast<double>(late) / static_cast<double>(run.frames.size())));
  fmt::print("{} of {} starts had samples in the first frame\n", seen, restarts);
  fmt::print("{:<22} {:>10} {:>10} {:>10}\n", "", "median", "99 %", "largest");
  for (const PreviewFigure& figure : figures_of(run)) {
    fmt::print("{:<22} {:>10.3f} {:>10.3f} {:>10.3f} {}\n", figure.name, figure.value.median,
               figure.value.percentile_99, figure.value.largest, figure.unit);
  }
}

void print_json(const PreviewRun& run, const PreviewArguments& arguments) {
  Json list = Json::array();
  for (const PreviewFigure& figure : figures_of(run)) {
    list.push_back({{"name", figure.name},
                    {"unit", figure.unit},
                    {"median", figure.value.median},
                    {"percentile_99", figure.value.percentile_99},
                    {"largest", figure.value.largest}});
  }
  const auto [seen, restarts] = restarts_seen(run);
  const Json json = {{"version", build_info().version},
                     {"compiler", build_info().compiler},
                     {"processor", machine_info().processor},
                     {"scene", arguments.scene},
                     {"method", arguments.method},
                     {"size", arguments.size},
                     {"view", arguments.view},
                     {"tracker", arguments.tracker},
                     {"rate_hz", arguments.rate_hz},
                     {"threads", run.threads},
                     {"frames", run.frames.size()},
                     {"late_frames", late_frames(run)},
                     {"starts", restarts},
                     {"starts_seen_in_the_first_frame", seen},
                     {"figures", list}};
  fmt::print("{}\n", json.dump(2));
}

void run_bench(const PreviewArguments& arguments, const SceneFinder& find_scene,
               const std::stop_token& stop) {
  RenderSettings settings;
  settings.method = arguments.method;
  settings.size = parse_size("--size", arguments.size);
  settings.threads = arguments.threads;
  if (!arguments.view.empty()) {
    settings.view = parse_size("--view", arguments.view);
  }
  const PreviewRun run = run_frames(arguments, find_scene(arguments.scene), settings, stop);
  if (run.frames.empty()) {
    return;
  }
  arguments.json ? print_json(run, arguments) : print_text(run);
}

}  // namespace

void add_bench_preview(CLI::App& bench, const SceneFinder& find_scene,
                       const std::stop_token& stop) {
  const auto arguments = std::make_shared<PreviewArguments>();
  CLI::App* command = bench.add_subcommand(
      "preview", "Whether a live preview's frames are in time, without a window");
  command->add_option("SCENE", arguments->scene, "A scene's name, or a .glb, .gltf or .obj file")
      ->required();
  command->add_option("--method", arguments->method, "As render's")->capture_default_str();
  command->add_option("--size", arguments->size, "Of the film, WIDTHxHEIGHT")
      ->capture_default_str();
  command->add_option("--view", arguments->view,
                      "Resample every frame to so many pixels, WIDTHxHEIGHT (default: do not; a "
                      "window's graphics card does)");
  command->add_option("--tracker", arguments->tracker, "A profile's name or file")
      ->capture_default_str();
  command->add_option("--rate", arguments->rate_hz, "Of the display, in Hz")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  command->add_option("--frames", arguments->frames, "How many")
      ->check(CLI::Range(1, 10'000'000))
      ->capture_default_str();
  command->add_option("--restart-every", arguments->restart_every, "Frames")
      ->check(CLI::Range(1, 10'000'000))
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "0: every core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print the figures as JSON");
  command->footer("Example: foveola bench preview arcade --frames 10000");
  command->callback([arguments, find_scene, stop] { run_bench(*arguments, find_scene, stop); });
}

}  // namespace foveola
