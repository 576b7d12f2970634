#include "renderer/commands/preview/preview_arguments.h"

#include <array>

#include <CLI/CLI.hpp>

#include "renderer/base/files/files.h"
#include "renderer/base/text/words.h"
#include "renderer/command_line/common_options.h"
#include "renderer/command_line/output_options.h"
#include "renderer/commands/gaze_filter_option.h"
#include "renderer/commands/headset_option.h"
#include "renderer/gaze/recordings.h"
#include "renderer/image/image_file.h"

namespace foveola {
namespace {

constexpr auto overlays =
    std::to_array<Word<bool PreviewChoices::*>>({{"gaze", &PreviewChoices::shows_gaze},
                                                 {"rings", &PreviewChoices::shows_rings},
                                                 {"density", &PreviewChoices::shows_density},
                                                 {"times", &PreviewChoices::shows_frame_times},
                                                 {"latency", &PreviewChoices::shows_latency},
                                                 {"view", &PreviewChoices::shows_view},
                                                 {"warnings", &PreviewChoices::shows_warnings},
                                                 {"help", &PreviewChoices::shows_help}});

/// The methods that a key cycles through, the requested one first.
std::vector<std::string> methods_from(const std::string& first) {
  std::vector<std::string> methods = {first};
  for (const char* method : {"od", "vp", "fv", "hybrid"}) {
    if (method != first) {
      methods.emplace_back(method);
    }
  }
  return methods;
}

PreviewChoices choices_from(const PreviewArguments& arguments) {
  PreviewChoices choices{
      .methods = methods_from(arguments.method),
      .look = {.fill_unsampled = arguments.fill_unsampled, .curve = tone_curve(arguments.look)}};
  for (const std::string& name : arguments.shown) {
    choices.*value_of(overlays, name) = true;
  }
  return choices;
}

}  // namespace

void add_preview_options(CLI::App& command, PreviewArguments& arguments) {
  add_scene_option(command, arguments.scene);
  command.add_option("--method", arguments.method,
                     "The method to begin with, as render's --method");
  add_film_size_option(command, arguments.film_size);
  command.add_option("--display", arguments.display,
                     "A display's profile, by name or file: a monitor's window, or a headset's two "
                     "views side by side");
  CLI::Option* tracker =
      command.add_option("--tracker", arguments.tracker,
                         "Source of the gaze: pointer, or a tracker's profile (see tracker list)");
  add_headset_option(command, arguments.display, arguments.tracker);
  command
      .add_option("--gaze-file", arguments.gaze_file,
                  "Replay a recorded gaze from this file instead")
      ->excludes(tracker);
  command.add_option("--gaze-filter", arguments.gaze_filter,
                     std::string("Filters of the gaze: ") + gaze_filter_notation);
  command.add_flag("--correct-gaze", arguments.correct_gaze,
                   "Correct the gaze by what each check of the tracker (key c) finds");
  add_viewpoint_options(command, arguments.look);
  command
      .add_option("--head-file", arguments.head_file,
                  "Replay recorded head poses from this file instead")
      ->excludes(command.get_option("--head"));
  command.add_option("--window", arguments.window, "Size of the window, WIDTHxHEIGHT");
  CLI::Option* full_screen = command.add_flag("--full-screen", arguments.full_screen,
                                              "Fill a monitor instead of a window");
  command.add_option("--monitor", arguments.monitor, "Number of the monitor to fill, from 0")
      ->check(CLI::Range(0, 100))
      ->needs(full_screen);
  CLI::Option* true_angles = command.add_flag("--true-angles", arguments.true_angles,
                                              "Show a monitor's window at true angles, like a pane "
                                              "of glass, as the participants of a study see it");
  add_fov_option(command, arguments.look, "the scene's camera's, in a monitor's window");
  command.get_option("--fov")->excludes(true_angles);
  add_light_options(command, arguments.look);
  add_exposure_option(command, arguments.look);
  add_tone_option(command, arguments.look);
  command.add_flag("--fill-unsampled", arguments.fill_unsampled,
                   "Fill unsampled pixels from sampled ones around them; otherwise they are black");
  command.add_option("--show", arguments.shown, "Overlays to show to begin with")
      ->delimiter(',')
      ->check(CLI::IsMember(texts_of(overlays)));
  command.add_flag("--watch", arguments.watch,
                   "Expect the scene's files to change, so that the first change, too, is shown as "
                   "soon as later ones; rays take a third longer");
  CLI::Option* frames =
      command
          .add_option("--frames", arguments.frames,
                      "End after this many frames (default: when the window is closed)")
          ->check(CLI::Range(1, 1'000'000'000));
  mark_output(command.add_option(
                  "--screenshot", arguments.screenshot,
                  "Write the last frame's picture, with its overlays, as .png, .jpg or .exr"))
      ->needs(frames);
  add_path_options(command, arguments.trace);
  add_threads_option(command, arguments.threads);
  add_json_option(command, arguments.json);
}

PreviewRequest preview_request(const PreviewArguments& arguments, const SceneFinder& find_scene) {
  if (!arguments.screenshot.empty()) {
    require_image_extension(arguments.screenshot);
    require_writable(arguments.screenshot);
  }
  require_method(arguments.method);
  PreviewRequest request{.scene = scene_choices(arguments.look),
                         .fov = fields_of_view(arguments.look),
                         .exposure = exposure_choice(arguments.look),
                         .choices = choices_from(arguments),
                         .window = parse_size("--window", arguments.window),
                         .display = read_display_profile(arguments.display),
                         .tracker = read_tracker_profile(arguments.tracker),
                         .gaze_filter = parse_gaze_filter(arguments.gaze_filter)};
  request.render.film_size = arguments.film_size;
  request.render.trace = arguments.trace;
  request.render.visits_pixels_in_rounds = true;
  if (!arguments.gaze_file.empty()) {
    request.replayed_gaze = read_gaze_file(arguments.gaze_file);
  }
  if (!arguments.head_file.empty()) {
    request.replayed_head = read_head_file(arguments.head_file);
    // Framing and exposure are for the initial view.
    request.scene.head = request.replayed_head.front().heading;
  }
  request.source = lit_scene(arguments.scene, arguments.look, find_scene);
  return request;
}

}  // namespace foveola
