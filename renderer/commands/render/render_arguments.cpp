#include "renderer/commands/render/render_arguments.h"

#include <algorithm>
#include <array>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/words.h"
#include "renderer/command_line/common_options.h"
#include "renderer/command_line/output_options.h"
#include "renderer/progressive/render_limits.h"
#include "renderer/view/view_sampler.h"

namespace foveola {
namespace {

constexpr std::array splits{Word<RenderPart::By>{"tiles", RenderPart::By::tiles},
                            Word<RenderPart::By>{"seeds", RenderPart::By::seeds}};
constexpr double usual_samples_per_pixel = 32.0;
constexpr double default_samples_per_pixel_of_panorama = 16.0;

constexpr const char* panorama_group = "360-degree image";

/// Whether a 360-degree image was requested: by name, or by an option that only it has.
bool is_panorama(const CLI::App& command) {
  return std::ranges::any_of(command.get_options(), [](const CLI::Option* option) {
    return option->get_group() == panorama_group && option->count() > 0;
  });
}

/// The method, with its pointer fixed at --pointer.
std::string method_from(const RenderArguments& arguments) {
  const std::string& typed = arguments.settings.method;
  require_method(typed);
  print_notes(method_notes(typed));
  if (arguments.pointer.empty()) {
    return typed;
  }
  const std::string method =
      with_pointer(typed, parse_azimuth_elevation("--pointer", arguments.pointer));
  require(method != typed, "--pointer", "needs the method pointer, or a hybrid of it");
  require_method(method);
  return method;
}

/// Reads the options of the display's view.
void read_view(const RenderArguments& arguments, RenderSettings& settings) {
  const FieldsOfView fov = fields_of_view(arguments.look)
                               .value_or(FieldsOfView{settings.field_of_view.horizontal_deg, {}});
  settings.field_of_view = {.horizontal_deg = fov.horizontal_deg,
                            .vertical_deg = fov.vertical_deg.value_or(fov.horizontal_deg)};
  if (!arguments.view.empty()) {
    settings.view = parse_size("--view-size", arguments.view_size);
    if (!fov.vertical_deg) {
      const double height_by_width = static_cast<double>(settings.view->y) / settings.view->x;
      settings.field_of_view.vertical_deg = fov_across_deg(height_by_width, fov.horizontal_deg);
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

void read_panorama(const RenderArguments& arguments, RenderSettings& settings) {
  settings.method = method_from(arguments);
  if (!arguments.size.empty()) {
    settings.progressive.film_size = parse_size("--size", arguments.size);
  }
  if (!arguments.gaze.empty()) {
    settings.gaze = parse_azimuth_elevation("--gaze", arguments.gaze);
  }
  read_view(arguments, settings);
}

PictureChoices picture_from(const RenderArguments& arguments) {
  PictureChoices picture;
  if (!arguments.size.empty()) {
    picture.size = parse_size("--size", arguments.size);
  }
  if (const std::optional<FieldsOfView> fov = fields_of_view(arguments.look)) {
    picture.horizontal_fov_deg = fov->horizontal_deg;
    picture.vertical_fov_deg = fov->vertical_deg;
  }
  return picture;
}

void add_panorama_options(CLI::App& command, RenderArguments& arguments) {
  const std::string usual_group = command.option_defaults()->get_group();
  command.option_defaults()->group(panorama_group);
  command.add_flag(
      "--panorama", arguments.panorama,
      "Make a 360-degree image instead of a picture; implied by each option of this group");
  command.add_option(
      "--method", arguments.settings.method,
      "Sampling method: od, vp, vp-rect, fv, fv-paper, fv-map, mask, pointer, crop or "
      "a hybrid such as hybrid:0.9*fv+0.1*od; with settings as in "
      "fv:acuity=watson,cutoff=60 or mask:file=painted.png,floor=0.1");
  command.add_option(
      "--gaze", arguments.gaze,
      "Gaze: azimuth,elevation in degrees in the world (default: the head's direction)");
  command.add_option("--pointer", arguments.pointer,
                     "Direction of the method pointer: azimuth,elevation in degrees in the world "
                     "(default: the gaze)");
  command.add_option("--lens", arguments.lens,
                     "A headset's lens: AXIS_X,AXIS_Y,K1,K2 as in a protocol's [display.lens]");
  CLI::Option* view = mark_output(command.add_option(
      "--view", arguments.view, "Also write the display's view, as .exr, .png or .jpg"));
  command
      .add_option("--view-size", arguments.view_size,
                  "Size of the display's image in pixels, WIDTHxHEIGHT")
      ->needs(view);
  command
      .add_flag("--fill-unsampled", arguments.fill_unsampled,
                "Fill unsampled pixels of the display's image from sampled ones around them; "
                "otherwise they are black")
      ->needs(view);
  command.add_option(
      "--adaptive", arguments.adaptive_contrast,
      "Adaptive sampling: take no more samples of pixels whose noise is below this "
      "contrast, for instance 0.01 at the gaze and more elsewhere, as acuity falls; 0: "
      "off");
  command.option_defaults()->group(usual_group);
}

void add_budget_options(CLI::App& command, RenderArguments& arguments) {
  CLI::Option_group* budget = command.add_option_group("budget", "How much to render");
  budget->add_option("--spp", arguments.samples_per_pixel,
                     fmt::format("Samples per pixel on average over the image (default: {}, or {} "
                                 "of a 360-degree image)",
                                 usual_samples_per_pixel, default_samples_per_pixel_of_panorama));
  budget->add_option("--samples", arguments.samples, "Number of samples over the whole image");
  budget->add_option("--seconds", arguments.seconds, "Seconds of tracing");
  budget->require_option(0, 1);
}

std::optional<RenderPart> part_from(const RenderArguments& arguments) {
  if (arguments.shard.empty()) {
    return std::nullopt;
  }
  require(!arguments.seconds, "--shard",
          "needs --spp or --samples: seconds differ between machines");
  require(arguments.adaptive_contrast == 0.0, "--shard",
          "cannot be combined with --adaptive, which needs the whole film");
  require(arguments.view.empty(), "--shard",
          "cannot be combined with --view, which shows the whole film");
  return RenderPart{.shard = parse_shard("--shard", arguments.shard),
                    .by = value_of(splits, arguments.split)};
}

void add_part_options(CLI::App& command, RenderArguments& arguments) {
  CLI::Option* const shard = command.add_option("--shard", arguments.shard,
                                                "Render only the Kth of N parts, as K/N, into a "
                                                ".film; foveola merge-images merges all parts");
  shard->group("Parts");
  command
      .add_option("--split", arguments.split,
                  "Kind of parts: tiles, each of which draws all directions and traces those of "
                  "its own, so that together they are the whole image bit for bit; or seeds, each "
                  "of which takes a part of the samples, from random numbers of its own")
      ->needs(shard)
      ->check(CLI::IsMember(texts_of(splits)))
      ->group("Parts");
  command
      .add_flag(
          "--resume", arguments.resume,
          "Continue the .film of this command after a stop or kill; begin it if there is none")
      ->group("Parts");
}

void add_tracing_options(CLI::App& command, RenderArguments& arguments) {
  command.add_flag("--variance", arguments.settings.progressive.keep_variances,
                   "Add to the .exr the variance of the luminance of each pixel's samples");
  add_path_options(command, arguments.settings.progressive.trace);
  add_threads_option(command, arguments.settings.threads);
  command.add_flag("--diffuse", arguments.settings.scene.diffuse,
                   "Show every material as Lambertian in its base colour, to compare renderers");
  command.add_option("--clamp", arguments.largest_radiance,
                     "Clamp each sample's radiance to this: less noise, but too dark a picture");
}

}  // namespace

void require(bool valid, const std::string& option, const std::string& what) {
  if (!valid) {
    throw UsageError(option, what, "see foveola render --help");
  }
}

RenderSettings settings_from(const CLI::App& command, const RenderArguments& arguments) {
  RenderSettings settings = arguments.settings;
  ProgressiveSettings& progressive = settings.progressive;
  const bool panorama = is_panorama(command);
  const SceneChoices viewpoint = scene_choices(arguments.look);
  settings.scene.camera = viewpoint.camera;
  settings.scene.camera_name = viewpoint.camera_name;
  settings.scene.head = viewpoint.head;
  settings.exposure = exposure_choice(arguments.look);
  if (panorama) {
    read_panorama(arguments, settings);
  } else {
    settings.picture = picture_from(arguments);
  }
  settings.budget =
      budget_of({.samples_per_pixel = arguments.samples_per_pixel,
                 .samples = arguments.samples,
                 .seconds = arguments.seconds,
                 .default_samples_per_pixel =
                     panorama ? default_samples_per_pixel_of_panorama : usual_samples_per_pixel});
  require_possible(settings);
  require(arguments.largest_radiance > 0.0, "--clamp", "must be positive");
  require(arguments.adaptive_contrast >= 0.0 && arguments.adaptive_contrast < 1.0, "--adaptive",
          "must lie between 0 (off) and 1");
  if (arguments.adaptive_contrast > 0.0) {
    progressive.adaptive = VisibleNoise{.contrast = arguments.adaptive_contrast};
  }
  progressive.trace.largest_radiance = static_cast<float>(arguments.largest_radiance);
  settings.part = part_from(arguments);
  return settings;
}

void add_render_options(CLI::App& command, RenderArguments& arguments) {
  add_scene_option(command, arguments.scene);
  command.add_option("-o,--output", arguments.output,
                     "The image to write, as .exr (R, G, B, samples), .png or .jpg; or a .film, "
                     "for --resume and merge-images");
  command.add_option(
      "--size", arguments.size,
      fmt::format("Size of the image in pixels, WIDTHxHEIGHT (default: {}, cut to the "
                  "camera's aspect ratio, or {} of a 360-degree image)",
                  size_text(default_picture_size),
                  size_text(arguments.settings.progressive.film_size)));
  add_viewpoint_options(command, arguments.look);
  add_fov_option(
      command, arguments.look,
      fmt::format("the camera's own, else {} along the larger side; {} of the display in "
                  "a 360-degree image",
                  default_picture_fov_deg, arguments.settings.field_of_view.horizontal_deg));
  add_light_options(command, arguments.look);
  add_exposure_option(command, arguments.look);
  add_tone_option(command, arguments.look);
  add_budget_options(command, arguments);
  add_tracing_options(command, arguments);
  add_panorama_options(command, arguments);
  add_part_options(command, arguments);
  command.add_option(
      "--replay", arguments.replay,
      "Instead of rendering, trace one path of this render again and print its vertices: "
      "x,y,sample");
  add_json_option(command, arguments.json);
}

}  // namespace foveola
