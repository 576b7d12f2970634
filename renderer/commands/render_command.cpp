#include "renderer/commands/render_command.h"

#include <charconv>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/environment_option.h"
#include "renderer/commands/former_option.h"
#include "renderer/commands/light_units_option.h"
#include "renderer/commands/render_report.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {
namespace {

/// The command line of `render`, as typed.
struct RenderArguments {
  RenderSettings settings;  ///< whatever needs no notation of its own
  std::string scene;
  std::string output;
  std::string size = size_text(settings.progressive.film_size);
  std::string camera;
  std::string head;
  std::string gaze;
  std::string pointer;
  std::string fov = fmt::format("{}", settings.field_of_view.horizontal_deg);
  std::string lens;
  std::string view;
  std::string view_size = size_text(usual_view_size);
  bool fill_unsampled = false;
  double samples_per_pixel = 0.0;
  std::int64_t samples = 0;
  double seconds = 0.0;
  std::string environment;
  double exposure_stops = 0.0;
  double environment_rotation_deg = 0.0;
  double environment_strength = 1.0;
  double light_radius_m = 0.0;
  double sun_radius_deg = 0.0;
  double largest_radiance = settings.progressive.trace.largest_radiance;
  double adaptive_contrast = 0.0;
  std::string replay;
  bool json = false;
};

void require(bool valid, const std::string& option, const std::string& what) {
  if (!valid) {
    throw UsageError(option, what, "see foveola render --help");
  }
}

RenderBudget budget_from(const CLI::App& command, const RenderArguments& arguments,
                         const IVec2& size) {
  RenderBudget budget;
  if (command.count("--spp") > 0) {
    const double pixels = static_cast<double>(size.x) * size.y;
    const double samples = std::round(arguments.samples_per_pixel * pixels);
    require(samples >= 1.0 && samples <= 1e15, "--spp", "must give at least one sample");
    budget.samples = static_cast<std::uint64_t>(samples);
  } else if (command.count("--samples") > 0) {
    require(arguments.samples >= 1, "--samples", "must be at least 1");
    budget.samples = static_cast<std::uint64_t>(arguments.samples);
  } else if (command.count("--seconds") > 0) {
    require(arguments.seconds > 0.0 && std::isfinite(arguments.seconds), "--seconds",
            "must be a positive number");
    budget.seconds = arguments.seconds;
  } else {
    constexpr std::uint64_t default_samples_per_pixel = 16;
    budget.samples = default_samples_per_pixel * size.x * size.y;
  }
  return budget;
}

/// The method, with its pointer held where --pointer says.
std::string method_from(const RenderArguments& arguments) {
  const std::string& typed = arguments.settings.method;
  require_method(typed);
  print_method_notes(typed);
  if (arguments.pointer.empty()) {
    return typed;
  }
  const std::string method =
      with_pointer(typed, parse_azimuth_elevation("--pointer", arguments.pointer));
  require(method != typed, "--pointer", "needs the method pointer, or a hybrid of it");
  require_method(method);
  return method;
}

/// What is seen of the sphere, and how.
void read_view(const RenderArguments& arguments, RenderSettings& settings) {
  const FieldsOfView fov = parse_fields_of_view("--fov", arguments.fov);
  settings.field_of_view = {.horizontal_deg = fov.horizontal_deg,
                            .vertical_deg = fov.vertical_deg.value_or(fov.horizontal_deg)};
  if (!arguments.view.empty()) {
    settings.view = parse_size("--view-size", arguments.view_size);
    if (!fov.vertical_deg) {
      const double half_width = std::tan(0.5 * radians(fov.horizontal_deg));
      const double half_height = half_width * settings.view->y / settings.view->x;
      settings.field_of_view.vertical_deg = degrees(2.0 * std::atan(half_height));
    }
  }
  settings.unsampled = arguments.fill_unsampled ? UnsampledPixels::filled : UnsampledPixels::black;
  if (!arguments.lens.empty()) {
    settings.field_of_view.lens = parse_lens("--lens", arguments.lens);
    try {
      Viewport({}, settings.field_of_view);
    } catch (const Error& error) {
      throw UsageError("--lens", error.what());
    }
  }
}

RenderSettings settings_from(const CLI::App& command, const RenderArguments& arguments) {
  RenderSettings settings = arguments.settings;
  ProgressiveSettings& progressive = settings.progressive;
  settings.method = method_from(arguments);
  progressive.film_size = parse_size("--size", arguments.size);
  if (!arguments.camera.empty()) {
    settings.scene.camera = parse_vec3("--camera", arguments.camera);
  }
  if (!arguments.head.empty()) {
    settings.scene.head = parse_azimuth_elevation("--head", arguments.head);
  }
  if (!arguments.gaze.empty()) {
    settings.gaze = parse_azimuth_elevation("--gaze", arguments.gaze);
  }
  read_view(arguments, settings);
  settings.budget = budget_from(command, arguments, progressive.film_size);
  require(progressive.trace.max_depth >= 1, "--max-depth", "must be at least 1");
  require(settings.threads >= 0 && settings.threads <= 1024, "--threads",
          "must lie between 0 (every core) and 1024");
  require(arguments.largest_radiance > 0.0, "--clamp", "must be positive");
  require(arguments.adaptive_contrast >= 0.0 && arguments.adaptive_contrast < 1.0, "--adaptive",
          "must lie between 0 (off) and 1");
  if (arguments.adaptive_contrast > 0.0) {
    progressive.adaptive = VisibleNoise{.contrast = arguments.adaptive_contrast};
  }
  progressive.trace.largest_radiance = static_cast<float>(arguments.largest_radiance);
  return settings;
}

/// The scene's light and exposure as the arguments change them.
void apply_lighting(const CLI::App& command, const RenderArguments& arguments,
                    SceneSource& source) {
  if (!arguments.environment.empty()) {
    replace_environment(arguments.environment, source);
  }
  source.exposure_stops = source.exposure_stops.value_or(0.0) + arguments.exposure_stops;
  source.environment_rotation_rad += radians(arguments.environment_rotation_deg);
  source.environment_strength *= arguments.environment_strength;
  if (command.count("--light-radius") > 0) {
    source.light_radius_m = static_cast<float>(arguments.light_radius_m);
  }
  if (command.count("--sun-radius") > 0) {
    source.sun_angular_radius_rad = static_cast<float>(radians(arguments.sun_radius_deg));
  }
}

void run_replay(const CLI::App& command, const RenderArguments& arguments,
                const RenderSettings& settings, const SceneFinder& find_scene,
                const std::stop_token& stop) {
  const SampleAddress address =
      parse_sample("--replay", arguments.replay, settings.progressive.film_size);
  require(settings.budget.seconds == 0.0, "--seconds", "does not go with --replay; use --samples");
  SceneSource source = find_scene(arguments.scene);
  apply_lighting(command, arguments, source);
  const ReplayedPath path = replay(source, settings, address, stop);
  if (arguments.json) {
    fmt::print("{}\n", json_path(path).dump(2));
  } else {
    print_path(path);
  }
}

/// What the image was made with, the light as typed included.
ImageFacts header_of(const RenderReport& report, const RenderSettings& settings,
                     const CLI::App& command, const RenderArguments& arguments) {
  ImageFacts facts = facts_of(report, settings, arguments.scene);
  for (const char* name : {"environment", "environment-rotation", "environment-strength",
                           "light-units", "light-radius", "sun-radius"}) {
    const CLI::Option* option = command.get_option(fmt::format("--{}", name));
    if (option->count() > 0) {
      facts[fmt::format("foveola:{}", name)] = option->as<std::string>();
    }
  }
  return facts;
}

void run_render(const CLI::App& command, const RenderArguments& arguments,
                const SceneFinder& find_scene, const std::stop_token& stop) {
  RenderSettings settings = settings_from(command, arguments);
  if (!arguments.replay.empty()) {
    run_replay(command, arguments, settings, find_scene, stop);
    return;
  }
  require(!arguments.output.empty(), "--output", "is required");
  require_image_extension(arguments.output);
  require_writable(arguments.output);
  if (!arguments.view.empty()) {
    require_image_extension(arguments.view);
    require_writable(arguments.view);
  }
  SceneSource source = find_scene(arguments.scene);
  apply_lighting(command, arguments, source);
  const Rendering rendering = render(source, settings, stop);
  if (rendering.report.samples == 0) {
    return;
  }
  write_film_image(arguments.output, rendering.image, source.exposure_stops.value_or(0.0),
                   header_of(rendering.report, settings, command, arguments));
  if (settings.view) {
    write_image(arguments.view, rendering.view, source.exposure_stops.value_or(0.0));
  }
  const RenderNames names{.scene = arguments.scene, .output = arguments.output};
  if (arguments.json) {
    fmt::print("{}\n", json_report(rendering.report, settings, names).dump(2));
  } else {
    print_report(rendering.report, settings, names);
  }
}

}  // namespace

void add_render(CLI::App& app, const SceneFinder& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = app.add_subcommand("render", "Render a 360-degree image, without a window");
  command->add_option("SCENE", arguments->scene, "A scene's name, or a .glb, .gltf or .obj file")
      ->required();
  command->add_option("-o,--output", arguments->output,
                      "The image to write, as .exr (R, G, B, samples) or .png");
  command
      ->add_option(
          "--method", arguments->settings.method,
          "Where the samples go: od, vp, vp-rect, fv, fv-paper, fv-map, mask, pointer, crop or a "
          "hybrid such as hybrid:0.9*fv+0.1*od; with settings as in "
          "fv:acuity=watson,cutoff=60 or mask:file=painted.png,floor=0.1")
      ->capture_default_str();
  command->add_option("--size", arguments->size, "Size of the image in pixels, WIDTHxHEIGHT")
      ->capture_default_str();
  command->add_option("--camera", arguments->camera, camera_help);
  command->add_option(
      "--head", arguments->head,
      "Where the head points: azimuth,elevation in degrees, azimuth from -Z towards +X "
      "(default: the scene's heading)");
  command->add_option(
      "--gaze", arguments->gaze,
      "Where the eye looks: azimuth,elevation in degrees in the world (default: where the "
      "head points)");
  command->add_option("--pointer", arguments->pointer,
                      "Where the method pointer points: azimuth,elevation in degrees in the world "
                      "(default: the gaze)");
  command
      ->add_option("--fov", arguments->fov,
                   "The viewport's field of view in degrees: WIDTH for both ways, or WIDTHxHEIGHT")
      ->capture_default_str();
  command->add_option("--lens", arguments->lens,
                      "A headset's lens: AXIS_X,AXIS_Y,K1,K2 as in a protocol's [display.lens]");
  CLI::Option* view = command->add_option("--view", arguments->view,
                                          "Also write what the display shows, as .exr or .png");
  command
      ->add_option("--view-size", arguments->view_size,
                   "Size of the display's image in pixels, WIDTHxHEIGHT")
      ->needs(view)
      ->capture_default_str();
  command
      ->add_flag(
          "--fill-unsampled", arguments->fill_unsampled,
          "Fill unsampled pixels of the display's image from what is known around them; they "
          "are black otherwise")
      ->needs(view);
  command->add_flag("--variance", arguments->settings.progressive.keep_variances,
                    "Add to the .exr the variance of the luminance of each pixel's samples");
  CLI::Option_group* budget = command->add_option_group("budget", "How much to render");
  budget->add_option("--spp", arguments->samples_per_pixel,
                     "Samples per pixel on average over the image (default: 16)");
  budget->add_option("--samples", arguments->samples, "Number of samples over the whole image");
  budget->add_option("--seconds", arguments->seconds, "Seconds of tracing");
  budget->require_option(0, 1);
  command
      ->add_option("--max-depth", arguments->settings.progressive.trace.max_depth,
                   "The most surface vertices of a path; 1 is direct light alone")
      ->capture_default_str();
  command
      ->add_option("--seed", arguments->settings.progressive.trace.seed,
                   "Seed of the random numbers; another seed gives other noise")
      ->capture_default_str();
  command
      ->add_option("--threads", arguments->settings.threads,
                   "Number of threads; 0: one for each core")
      ->capture_default_str();
  command
      ->add_option("--exposure", arguments->exposure_stops,
                   "Brighten a .png by so many stops; an .exr holds radiances, whatever this is")
      ->check(CLI::Range(-20.0, 20.0));
  command->add_option("--environment", arguments->environment, environment_help);
  command->add_option("--environment-rotation", arguments->environment_rotation_deg,
                      "Turn the environment by so many degrees, from -Z towards +X");
  command->add_option("--environment-strength", arguments->environment_strength,
                      "Multiply the environment's radiance by this");
  command->add_option(
      "--light-radius", arguments->light_radius_m,
      "Turn the file's point and spot lights into spheres of this radius in metres");
  command->add_option("--sun-radius", arguments->sun_radius_deg,
                      "Turn directional lights into discs of this angular radius in degrees");
  command->add_flag("--diffuse", arguments->settings.scene.diffuse,
                    "Show every material as Lambertian in its base colour, to compare renderers");
  command->add_option("--clamp", arguments->largest_radiance,
                      "Cut each sample's radiance to this: less noise, but too dark a picture");
  CLI::Option* const adaptive = command->add_option(
      "--adaptive", arguments->adaptive_contrast,
      "Adaptive sampling: take no more samples of pixels whose noise is below this contrast, for "
      "instance 0.01 at the gaze and more elsewhere, as acuity falls; 0: off");
  accept_former_name(*command, *adaptive, "--spare-done");
  command->add_option(
      "--replay", arguments->replay,
      "Instead of rendering, trace one path of this render again and print its vertices: "
      "x,y,sample");
  command->add_flag("--json", arguments->json, "Print the result as JSON");
  command->footer("Example: foveola render arcade -o arcade.exr --method fv --gaze 20,-5 --spp 4");
  command->callback([command, arguments, find = with_light_units(*command, find_scene), stop] {
    run_render(*command, *arguments, find, stop);
  });
}

}  // namespace foveola
