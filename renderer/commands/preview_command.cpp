#include "renderer/commands/preview_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/build_info.h"
#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/live_preview_json.h"
#include "renderer/commands/live_window.h"
#include "renderer/commands/look_options.h"
#include "renderer/commands/preview_report.h"
#include "renderer/commands/preview_surroundings.h"
#include "renderer/commands/warnings.h"
#include "renderer/gaze/gaze_source.h"
#include "renderer/gaze/recorded_eye_tracker.h"
#include "renderer/gaze/recorded_head.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/headless_render.h"
#include "renderer/window/live_preview.h"
#include "renderer/window/preview_panels.h"

namespace foveola {
namespace {

using Json = nlohmann::ordered_json;

struct PreviewCommand {
  std::string scene;
  LookArguments look;
  std::string method = "fv";
  std::string size = size_text(live_film_size);
  std::string display = "desktop";
  std::string tracker = "pointer";
  std::string gaze_file;
  std::string head_file;
  std::string window = "1280x720";
  int monitor = 0;
  bool full_screen = false;
  bool true_angles = false;
  bool fill_unsampled = false;
  bool correct_gaze = false;
  std::vector<std::string> shown;
  std::uint64_t frames = 0;
  std::string screenshot;
  TraceSettings trace;
  int threads = 0;
  bool json = false;
};

/// The methods that a key goes through, the one that was asked for first.
std::vector<std::string> methods_from(const std::string& first) {
  std::vector<std::string> methods = {first};
  for (const char* method : {"od", "vp", "fv", "hybrid"}) {
    if (method != first) {
      methods.emplace_back(method);
    }
  }
  return methods;
}

PreviewChoices choices_from(const PreviewCommand& command) {
  PreviewChoices choices{.methods = methods_from(command.method),
                         .look = {.fill_unsampled = command.fill_unsampled}};
  const std::vector<std::pair<std::string, bool*>> overlays = {
      {"gaze", &choices.shows_gaze},       {"rings", &choices.shows_rings},
      {"density", &choices.shows_density}, {"times", &choices.shows_frame_times},
      {"latency", &choices.shows_latency}, {"view", &choices.shows_view},
      {"help", &choices.shows_help}};
  for (const std::string& name : command.shown) {
    for (const auto& [overlay, choice] : overlays) {
      *choice = *choice || name == overlay;
    }
  }
  return choices;
}

RenderSettings render_settings(const PreviewCommand& command) {
  RenderSettings settings;
  settings.method = command.method;
  settings.progressive.film_size = parse_size("--size", command.size);
  settings.progressive.trace = command.trace;
  settings.threads = command.threads;
  return settings;
}

WindowEyeTracker open_gaze_source(const PreviewCommand& command, const DisplayProfile& display,
                                  const Clock& clock) {
  if (!command.gaze_file.empty()) {
    return {.tracker = std::make_unique<RecordedEyeTracker>(read_gaze_file(command.gaze_file),
                                                            clock.now(), Nanoseconds(0))};
  }
  return open_window_eye_tracker(read_tracker_profile(command.tracker), screen_of(display), clock);
}

/// Prints on standard error: standard output holds the report alone, for JSON's readers.
void print_notice(const std::string& line) { fmt::print(stderr, "{}\n", line); }

/// What the window shows of the scene at first is a picture of its size.
PictureChoices window_picture(const PreviewCommand& command, const IVec2& framebuffer) {
  PictureChoices choices{.size = framebuffer};
  if (const std::optional<FieldsOfView> fov = fields_of_view(command.look)) {
    choices.horizontal_fov_deg = fov->horizontal_deg;
    choices.vertical_fov_deg = fov->vertical_deg;
  }
  return choices;
}

/// Prints it if it is automatic.
double exposure_stops_of(const PreviewCommand& command, const LoadedScene& loaded,
                         const PictureChoices& picture, const Workers& workers) {
  const Viewport first_view(loaded.camera.heading,
                            picture_of(loaded.camera, picture).field_of_view);
  const Exposure exposure =
      chosen_exposure(exposure_choice(command.look), loaded, first_view, command.trace, workers);
  if (exposure.is_automatic) {
    print_notice("foveola: note: " + exposure_note(exposure));
  }
  return exposure.stops;
}

/// Loads the scene and shows it, in a thread of its own beside the window's.
LivePreviewReport show_scene(const PreviewCommand& command, const SceneSource& source,
                             const DisplayProfile& display, Window& window, WindowEvents& events,
                             const IVec2& framebuffer, const Clock& clock,
                             const std::stop_token& stop) {
  const RenderSettings settings = render_settings(command);
  Presenter presenter(window, clock);
  const Workers workers(settings.threads);
  const PictureChoices picture = window_picture(command, framebuffer);
  SceneChoices choices = scene_choices(command.look);
  choices.framed_for = picture_of({}, picture).field_of_view;
  const LoadedScene loaded(source, workers, choices);
  print_warnings(loaded.warnings);
  const double exposure_stops = exposure_stops_of(command, loaded, picture, workers);
  WindowEyeTracker gaze = open_gaze_source(command, display, clock);
  CorrectedEyeTracker eye(std::move(gaze.tracker));
  SteeredHeadTracker steered_head(loaded.camera.heading);
  std::optional<ScriptedHeadTracker> replayed;
  if (!command.head_file.empty()) {
    replayed.emplace(replayed_head(read_head_file(command.head_file), clock.now()));
  }
  HeadTracker& head = replayed ? static_cast<HeadTracker&>(*replayed) : steered_head;
  WidenedEyeTracker widened_eye(eye);
  const bool knows_view = gaze.pointer != nullptr;
  Preview preview(
      loaded.tracer,
      {.render = loaded.rendered_with(settings.progressive), .exposure_stops = exposure_stops},
      knows_view ? static_cast<EyeTracker&>(eye) : widened_eye, head, workers);
  Steering steering(steered_head, gaze.pointer);
  FreeCamera camera(surroundings_of(loaded), steered_head);
  LivePreviewSettings live{.display = display,
                           .tracker = read_tracker_profile(command.tracker),
                           .choices = choices_from(command),
                           .seed = command.trace.seed,
                           .framebuffer = framebuffer,
                           .keeps_last_picture = !command.screenshot.empty(),
                           .corrects_gaze = command.correct_gaze,
                           .notify = print_notice};
  live.choices.look.exposure_stops = exposure_stops;
  live.choices.look.curve = tone_curve(command.look);
  if (!command.true_angles) {
    const FieldOfView first_view = picture_of(loaded.camera, picture).field_of_view;
    live.larger_fov_deg = std::max(first_view.horizontal_deg, first_view.vertical_deg);
  }
  if (command.frames > 0) {
    live.frames = command.frames;
  }
  LivePreview shown(live, {.preview = &preview,
                           .steering = &steering,
                           .camera = &camera,
                           .eye = &eye,
                           .widened_eye = knows_view ? nullptr : &widened_eye,
                           .window = &window,
                           .events = &events,
                           .presenter = &presenter,
                           .workers = &workers,
                           .clock = &clock});
  LivePreviewReport report = shown.run(stop);
  report.threads = workers.threads();
  return report;
}

double seconds_to_first_picture(const LivePreviewReport& report) {
  return report.first_shown ? seconds(*report.first_shown) : 0.0;
}

PreviewRun run_of(const LivePreviewReport& report, const PreviewCommand& command,
                  const DisplayProfile& display) {
  return {.frames = report.frames,
          .tracker = read_tracker_profile(command.tracker),
          .display = display,
          .refresh_rate_hz = report.refresh_rate_hz,
          .is_resampled = true,
          .threads = report.threads};
}

void print_text(const LivePreviewReport& report, const PreviewCommand& command,
                const DisplayProfile& display) {
  fmt::print(
      "{}\nFirst picture {:.2f} s after the scene was loaded; refreshes at {:.2f} Hz, {}\n{}",
      report.graphics, seconds_to_first_picture(report), report.refresh_rate_hz,
      report.is_refresh_measured ? "measured" : "as the system or the display's profile says",
      preview_text(run_of(report, command, display)));
  for (const GazeCheck& check : report.gaze_checks) {
    fmt::print("Check of the tracker: {}\n", gaze_quality_line(check.quality));
    if (check.correction) {
      fmt::print("  corrected since then: {}\n", gaze_correction_line(*check.correction));
    }
  }
  fmt::print("The last view: {}\n", report.last_view);
  for (const std::string& monitor : report.lost_monitors) {
    fmt::print("The monitor {} was lost\n", monitor);
  }
}

void print_json(const LivePreviewReport& report, const PreviewCommand& command,
                const DisplayProfile& display) {
  Json json = {{"version", build_info().version},
               {"processor", machine_info().processor},
               {"graphics", report.graphics},
               {"scene", command.scene},
               {"size", command.size},
               {"display", command.display},
               {"tracker", command.tracker},
               {"methods", report.methods},
               {"final_window", {report.framebuffer.x, report.framebuffer.y}},
               {"last_view", report.last_view},
               {"seconds_to_first_picture", seconds_to_first_picture(report)},
               {"refresh_is_measured", report.is_refresh_measured},
               {"frame_count", report.frame_count},
               {"late", late_frames(report)},
               {"slow_drawing", slow_drawing(report)},
               {"lost_monitors", report.lost_monitors},
               {"gaze_checks", gaze_checks(report)}};
  json.update(preview_json(run_of(report, command, display)));
  fmt::print("{}\n", json.dump(2));
}

SceneSource scene_of(const PreviewCommand& command, const SceneFinder& find_scene) {
  SceneSource source = find_scene(command.scene);
  apply_light(command.look, source);
  return source;
}

void run_preview(const PreviewCommand& command, const SceneFinder& find_scene,
                 const std::stop_token& stop) {
  if (!command.screenshot.empty()) {
    require_image_extension(command.screenshot);
    require_writable(command.screenshot);
  }
  require_method(command.method);
  print_method_notes(command.method);
  DisplayProfile display = read_display_profile(command.display);
  const SceneSource source = scene_of(command, find_scene);
  const SteadyClock clock;
  WindowEvents events;
  Window window({.title = "Foveola: " + command.scene,
                 .size = parse_size("--window", command.window),
                 .monitor = command.full_screen ? std::optional(command.monitor) : std::nullopt},
                events, clock);
  display.refresh_rate_hz = said_refresh_rate_hz(window, command.monitor, display);
  LivePreviewReport report;
  run_beside(window, stop, [&](const IVec2& framebuffer) {
    report = show_scene(command, source, display, window, events, framebuffer, clock, stop);
  });
  if (report.last_picture) {
    write_display_picture(command.screenshot, *report.last_picture);
  }
  if (report.frame_count > 0) {
    command.json ? print_json(report, command, display) : print_text(report, command, display);
  }
}

}  // namespace

void add_preview(CLI::App& app, const SceneFinder& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<PreviewCommand>();
  CLI::App* command = app.add_subcommand("preview", "Open a window that renders where you look");
  command->add_option("SCENE", arguments->scene, "A scene's name, or a .glb, .gltf or .obj file")
      ->required();
  command
      ->add_option("--method", arguments->method, "The method to begin with, as render's --method")
      ->capture_default_str();
  command->add_option("--size", arguments->size, "Size of the film in pixels, WIDTHxHEIGHT")
      ->capture_default_str();
  command
      ->add_option("--display", arguments->display,
                   "A display's profile, by name or file: a monitor's window, or a headset's two "
                   "views side by side")
      ->capture_default_str();
  CLI::Option* tracker =
      command
          ->add_option(
              "--tracker", arguments->tracker,
              "Where the gaze comes from: pointer, or a tracker's profile (see tracker list)")
          ->capture_default_str();
  command
      ->add_option("--gaze-file", arguments->gaze_file,
                   "Replay a recorded gaze from this file instead")
      ->excludes(tracker);
  command->add_flag("--correct-gaze", arguments->correct_gaze,
                    "Correct the gaze by what each check of the tracker (key c) finds");
  add_viewpoint_options(*command, arguments->look);
  command
      ->add_option("--head-file", arguments->head_file,
                   "Replay recorded head poses from this file instead")
      ->excludes(command->get_option("--head"));
  command->add_option("--window", arguments->window, "Size of the window, WIDTHxHEIGHT")
      ->capture_default_str();
  CLI::Option* full_screen = command->add_flag("--full-screen", arguments->full_screen,
                                               "Fill a monitor instead of a window");
  command->add_option("--monitor", arguments->monitor, "Which monitor to fill, counted from 0")
      ->check(CLI::Range(0, 100))
      ->needs(full_screen)
      ->capture_default_str();
  CLI::Option* true_angles = command->add_flag(
      "--true-angles", arguments->true_angles,
      "Show on a monitor what a pane of its size would let through, as the participants of a study "
      "see it");
  add_fov_option(*command, arguments->look,
                 "a monitor's window shows what the scene's camera shows");
  command->get_option("--fov")->excludes(true_angles);
  add_light_options(*command, arguments->look);
  add_exposure_option(*command, arguments->look);
  add_tone_option(*command, arguments->look);
  command->add_flag(
      "--fill-unsampled", arguments->fill_unsampled,
      "Fill unsampled pixels from what is known around them; they are black otherwise");
  command->add_option("--show", arguments->shown, "Overlays to show to begin with")
      ->delimiter(',')
      ->check(CLI::IsMember({"gaze", "rings", "density", "times", "latency", "view", "help"}));
  CLI::Option* frames =
      command
          ->add_option("--frames", arguments->frames,
                       "End after so many frames (default: when the window is closed)")
          ->check(CLI::Range(1, 1'000'000'000));
  command
      ->add_option("--screenshot", arguments->screenshot,
                   "Write the last frame's picture, with all that stands over it, as .png or .exr")
      ->needs(frames);
  command
      ->add_option("--max-depth", arguments->trace.max_depth, "The most surface vertices of a path")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--seed", arguments->trace.seed,
                   "Seed of the random numbers; another seed gives other noise")
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "Number of threads; 0: one for each core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print the report as JSON");
  command->footer("Example: foveola preview arcade --method fv (? shows the keys)");
  command->callback([arguments, find_scene, stop] { run_preview(*arguments, find_scene, stop); });
}

}  // namespace foveola
