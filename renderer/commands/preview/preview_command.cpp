#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "renderer/base/build_info.h"
#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/transformed.h"
#include "renderer/base/work/programs.h"
#include "renderer/commands/commands.h"
#include "renderer/commands/preview/preview_arguments.h"
#include "renderer/commands/preview/preview_head.h"
#include "renderer/commands/preview/preview_report.h"
#include "renderer/gaze/recordings.h"
#include "renderer/headset/live_window.h"
#include "renderer/progressive/headless_render.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/view/view_sampler.h"
#include "renderer/window/live/live_preview.h"
#include "renderer/window/live/preview_panels.h"

namespace foveola {
namespace {

using Json = nlohmann::ordered_json;

/// Late frames, with their number from the first, and their delay in refreshes.
Json late_frames(const LivePreviewReport& report) {
  Json late = Json::array();
  const std::uint64_t first = report.frame_count - report.frames.size();
  for (std::size_t i = 0; i < report.frames.size(); ++i) {
    if (report.frames[i].is_late()) {
      late.push_back({{"frame", first + i}, {"refreshes", report.frames[i].missed_refreshes}});
    }
  }
  return late;
}

/// Each check of the tracker, and the resulting correction.
Json gaze_checks(const LivePreviewReport& report) {
  Json checks = Json::array();
  const auto row = [](const DVec3& weights) { return Json{weights.x, weights.y, weights.z}; };
  for (const GazeCheck& check : report.gaze_checks) {
    Json json = {{"data_loss", check.quality.data_loss}};
    if (const auto& figures = check.quality.figures) {
      json["accuracy_deg"] = figures->accuracy_deg;
      json["precision_rms_deg"] = figures->precision_rms_deg;
      json["precision_sd_deg"] = figures->precision_sd_deg;
    }
    if (check.correction) {
      json["correction"] = {{"azimuth", row(check.correction->azimuth)},
                            {"elevation", row(check.correction->elevation)}};
    }
    checks.push_back(std::move(json));
  }
  return checks;
}

/// Changes of the scene that were shown or refused, in order.
Json shown_changes(const LivePreviewReport& report) {
  return transformed(report.changes, [&](const ShownChange& change) {
    return Json{{"is_refused", change.is_refused},
                {"seconds_to_first_frame", seconds(change.after)}};
  });
}

/// Null unless drawing was found too slow for the window.
Json slow_drawing(const LivePreviewReport& report) {
  if (!report.slow_drawing) {
    return nullptr;
  }
  constexpr double ms_per_s = 1e3;
  const SlowDrawing& slow = *report.slow_drawing;
  return {{"drawing_ms", ms_per_s * seconds(slow.drawing)},
          {"refresh_interval_ms", ms_per_s * seconds(slow.interval)},
          {"window", {slow.framebuffer.x, slow.framebuffer.y}}};
}

/// The headset's changes, in words and in order.
Json headset_changes(const LivePreviewReport& report) {
  return transformed(report.headset_changes,
                     [&](const HeadsetChange change) { return words_for(change); });
}

WindowEyeTracker open_gaze_source(const PreviewRequest& request, LiveDisplay& display,
                                  const Clock& clock) {
  if (!request.replayed_gaze.empty()) {
    return {.tracker = std::make_unique<RecordedEyeTracker>(request.replayed_gaze, clock.now(),
                                                            Nanoseconds(0))};
  }
  return open_eye_tracker_of(display, request.tracker, clock);
}

/// Prints on standard error: standard output holds the report alone, for JSON's readers.
void print_notice(const std::string& line) { print_text(stderr, "{}\n", line); }

/// The window's initial view is a picture of its size.
PictureChoices window_picture(const PreviewRequest& request, const IVec2& framebuffer) {
  PictureChoices choices{.size = framebuffer};
  if (request.fov) {
    choices.horizontal_fov_deg = request.fov->horizontal_deg;
    choices.vertical_fov_deg = request.fov->vertical_deg;
  }
  return choices;
}

/// Prints an automatic exposure.
double exposure_stops_of(const PreviewRequest& request, const LoadedScene& loaded,
                         const PictureChoices& picture, const Workers& workers) {
  const Viewport first_view(loaded.camera.heading,
                            picture_of(loaded.camera, picture).field_of_view);
  const Exposure exposure =
      chosen_exposure(request.exposure, loaded, first_view, request.render.trace, workers);
  if (exposure.is_automatic) {
    print_notice("foveola: note: " + exposure_note(exposure));
  }
  return exposure.stops;
}

/// The window's news of a reloaded scene.
SceneChange change_of(ReloadedScene reloaded) {
  SceneChange change{.changed = reloaded.changed};
  if (reloaded.scene == nullptr) {
    change.remarks = {"foveola: note: the changed scene does not load: " +
                      printable(reloaded.refusal)};
    return change;
  }
  for (const std::string& warning : reloaded.scene->warnings) {
    change.remarks.push_back("foveola: warning: " + printable(warning));
  }
  change.warnings = reloaded.scene->warnings;
  change.has_studio_light = reloaded.scene->has_studio_light;
  change.tracer = &reloaded.scene->tracer;
  change.surroundings = surroundings_of(*reloaded.scene);
  change.owner = std::move(reloaded.scene);
  return change;
}

/// The destination of frames, and source of events.
struct ShownIn {
  Window& window;
  WindowEvents& events;
  LiveDisplay& display;
  const Clock& clock;
};

/// Loads the scene and shows it, in a thread of its own beside the window's.
LivePreviewReport show_scene(const PreviewArguments& arguments, const PreviewRequest& request,
                             const SceneFinder& find_scene, const ShownIn& shown_in,
                             const std::stop_token& stop) {
  const Clock& clock = shown_in.clock;
  const IVec2& framebuffer = shown_in.display.picture_px();
  const Workers workers(arguments.threads);
  const PictureChoices picture = window_picture(request, framebuffer);
  SceneChoices choices = request.scene;
  choices.lights_unlit = true;
  choices.framed_for = picture_of({}, picture).field_of_view;
  KeptForReload kept;
  if (arguments.watch) {
    kept.expects_changes();
  }
  auto first = [&] {
    const StuckLoadExit by_program(stop);
    const StuckLoadExit by_user(shown_in.events.closing());
    return load_beside(shown_in.events, stop, [&] {
      return std::make_shared<const LoadedScene>(request.source, workers, choices, &kept);
    });
  }();
  const LoadedScene& loaded = *first;  // until another replaces it
  print_warnings(loaded.warnings);
  std::optional<SceneReloader> reloader;
  try {
    reloader.emplace(
        loaded, kept,
        SceneReloader::Settings{
            .find_source = [&] { return lit_scene(arguments.scene, arguments.look, find_scene); },
            .choices = choices,
            .threads = arguments.threads});
  } catch (const Error& refusal) {
    print_notice(std::string("foveola: note: changes of the scene are not shown: ") +
                 refusal.what());
  }
  const double exposure_stops = exposure_stops_of(request, loaded, picture, workers);
  WindowEyeTracker gaze = open_gaze_source(request, shown_in.display, clock);
  CorrectedEyeTracker eye(std::move(gaze.tracker));
  PreviewHead head(request.replayed_head, shown_in.display, loaded.camera.heading, clock);
  WidenedEyeTracker widened_eye(eye);
  const bool knows_view = gaze.pointer != nullptr || shown_in.display.headset() != nullptr;
  Preview preview(loaded.tracer,
                  {.render = loaded.rendered_with(request.render),
                   .exposure_stops = exposure_stops,
                   .gaze_filter = request.gaze_filter},
                  knows_view ? static_cast<EyeTracker&>(eye) : widened_eye, head.shown(), workers);
  Steering steering(head.steered(), gaze.pointer);
  FreeCamera camera = head.camera_in(surroundings_of(loaded));
  LivePreviewSettings live{
      .display = shown_in.display.profile(),
      .tracker = request.tracker,
      .choices = request.choices,
      .seed = request.render.trace.seed,
      .framebuffer = framebuffer,
      .window_px = shown_in.display.window_px(),
      .keeps_last_picture = !arguments.screenshot.empty(),
      .corrects_gaze = arguments.correct_gaze,
      .warnings = loaded.warnings,
      .has_studio_light = loaded.has_studio_light,
      .notify = print_notice,
      .take_change =
          [&] {
            std::optional<ReloadedScene> reloaded = reloader ? reloader->take() : std::nullopt;
            return reloaded ? std::optional(change_of(std::move(*reloaded))) : std::nullopt;
          },
      .is_loading = [&] { return reloader && reloader->is_loading(); }};
  live.choices.look.exposure_stops = exposure_stops;
  if (!arguments.true_angles) {
    const FieldOfView first_view = picture_of(loaded.camera, picture).field_of_view;
    live.larger_fov_deg = std::max(first_view.horizontal_deg, first_view.vertical_deg);
  }
  if (arguments.frames > 0) {
    live.frames = arguments.frames;
  }
  LivePreview shown(live, {.preview = &preview,
                           .steering = &steering,
                           .camera = &camera,
                           .eye = &eye,
                           .widened_eye = knows_view ? nullptr : &widened_eye,
                           .window = &shown_in.window,
                           .events = &shown_in.events,
                           .presenter = &shown_in.display.presenter(),
                           .workers = &workers,
                           .clock = &clock});
  shown.keep_alive(std::move(first));
  LivePreviewReport report = shown.run(stop);
  report.threads = workers.threads();
  return report;
}

double seconds_to_first_picture(const LivePreviewReport& report) {
  return report.first_shown ? seconds(*report.first_shown) : 0.0;
}

PreviewRun run_of(const LivePreviewReport& report, const TrackerProfile& tracker,
                  const DisplayProfile& display) {
  return {.frames = report.frames,
          .tracker = tracker,
          .display = display,
          .refresh_rate_hz = report.refresh_rate_hz,
          .is_resampled = true,
          .threads = report.threads};
}

void print_words(const LivePreviewReport& report, const PreviewRun& run) {
  print_text(
      "{}\nFirst picture {:.2f} s after the scene was loaded; refreshes at {:.2f} Hz, {}\n{}",
      report.graphics, seconds_to_first_picture(report), report.refresh_rate_hz,
      report.is_refresh_measured ? "measured" : "by the system or the display's profile",
      preview_text(run));
  for (const GazeCheck& check : report.gaze_checks) {
    print_text("Check of the tracker: {}\n", gaze_quality_line(check.quality));
    if (check.correction) {
      print_text("  corrected since then: {}\n", gaze_correction_line(*check.correction));
    }
  }
  print_text("The last view: {}\n", report.last_view);
  for (const std::string& monitor : report.lost_monitors) {
    print_text("The monitor {} was lost\n", monitor);
  }
}

void print_json(const LivePreviewReport& report, const PreviewRun& run,
                const PreviewArguments& arguments) {
  Json json = {{"version", build_info().version},
               {"processor", machine_info().processor},
               {"graphics", report.graphics},
               {"scene", arguments.scene},
               {"size", size_text(arguments.film_size)},
               {"display", arguments.display},
               {"tracker", arguments.tracker},
               {"gaze_filter", arguments.gaze_filter},
               {"methods", report.methods},
               {"final_window", {report.framebuffer.x, report.framebuffer.y}},
               {"last_view", report.last_view},
               {"seconds_to_first_picture", seconds_to_first_picture(report)},
               {"refresh_is_measured", report.is_refresh_measured},
               {"frame_count", report.frame_count},
               {"late", late_frames(report)},
               {"changes", shown_changes(report)},
               {"slow_drawing", slow_drawing(report)},
               {"lost_monitors", report.lost_monitors},
               {"headset_changes", headset_changes(report)},
               {"gaze_checks", gaze_checks(report)}};
  json.update(preview_json(run));
  print_text("{}\n", json.dump(2));
}

void run_preview(const PreviewArguments& arguments, const SceneFinder& find_scene,
                 const std::stop_token& stop) {
  const PreviewRequest request = preview_request(arguments, find_scene);
  keep_freed_memory();
  print_notes(method_notes(arguments.method));
  silence_xr_loader();
  const SteadyClock clock;
  WindowEvents events;
  Window window(
      {.title = "Foveola: " + arguments.scene,
       .size = request.window,
       .monitor = arguments.full_screen ? std::optional(arguments.monitor) : std::nullopt},
      events, clock);
  DisplayProfile display = request.display;
  display.refresh_rate_hz = said_refresh_rate_hz(window, arguments.monitor, display);
  LivePreviewReport report;
  run_beside(window, stop, [&](const IVec2& framebuffer) {
    LiveDisplay shown_on(window, events, display, framebuffer, clock);
    display = shown_on.profile();
    report =
        show_scene(arguments, request, find_scene,
                   {.window = window, .events = events, .display = shown_on, .clock = clock}, stop);
  });
  if (report.last_picture) {
    write_display_picture(arguments.screenshot, *report.last_picture);
  }
  if (report.frame_count > 0) {
    const PreviewRun run = run_of(report, request.tracker, display);
    arguments.json ? print_json(report, run, arguments) : print_words(report, run);
  }
}

}  // namespace

void add_preview(CLI::App& app, const SceneFinder& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<PreviewArguments>();
  CLI::App* command = app.add_subcommand("preview", "Open a window that renders where you look");
  add_preview_options(*command, *arguments);
  command->footer("Example: foveola preview arcade --method fv (? shows the keys)");
  command->callback([arguments, find_scene, stop] { run_preview(*arguments, find_scene, stop); });
}

}  // namespace foveola
