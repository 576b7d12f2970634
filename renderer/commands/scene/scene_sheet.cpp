#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/commands.h"
#include "renderer/commands/look_options.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/image/image_file.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {
namespace {

constexpr int gap = 8;
constexpr double view_extent_deg = 90.0;
/// Margin of the film on each side of the view, whose pixels are not aligned with the film's.
constexpr double margin_deg = 2.0;

struct SheetArguments {
  LookArguments look;
  std::vector<std::string> scenes;
  std::string output;
  RenderSettings settings{.progressive = {.film_size = {1024, 512}}};
  int samples_per_pixel = 256;
};

/// One scene: a panorama, and the view from its camera with the head at rest.
struct SheetRow {
  RgbImage panorama;
  RgbImage view;  ///< square, as high as the panorama
};

void expose(RgbImage& image, double stops) {
  const float scale = exposure_scale(stops);
  for (Rgb& pixel : image.pixels) {
    pixel *= scale;
  }
}

/// The view is as high as the panorama, of a film with as many pixels per degree, and gets as many
/// samples.
SheetRow render_row(const SceneSource& source, RenderSettings settings,
                    const std::stop_token& stop) {
  SheetRow row;
  const int height = settings.progressive.film_size.y;
  Rendering all_around = render(source, settings, stop);
  print_warnings(all_around.report.warnings);
  row.panorama = std::move(all_around.image.color);
  const double stops = all_around.report.exposure.stops;
  settings.exposure.reset();
  settings.method = "vp";
  const double fov_deg = view_extent_deg + 2.0 * margin_deg;
  settings.field_of_view = {.horizontal_deg = fov_deg, .vertical_deg = fov_deg};
  settings.progressive.film_size *= 2;
  const RgbImage film = render(source, settings, stop).image.color;
  const double fov_rad = radians(view_extent_deg);
  row.view = viewport_image(
      film, Viewport(head_orientation(all_around.report.head), fov_rad, fov_rad), height, height);
  expose(row.panorama, stops);
  expose(row.view, stops);
  return row;
}

void paste(const RgbImage& from, int left, int top, RgbImage& to) {
  for (int y = 0; y < from.height; ++y) {
    for (int x = 0; x < from.width; ++x) {
      to.at(left + x, top + y) = from.at(x, y);
    }
  }
}

/// There is at least one row, and all are of one size.
RgbImage contact_sheet(const std::vector<SheetRow>& rows) {
  const RgbImage& panorama = rows.front().panorama;
  const int pitch = panorama.height + gap;
  RgbImage sheet(panorama.width + gap + rows.front().view.width,
                 static_cast<int>(rows.size()) * pitch - gap);
  std::ranges::fill(sheet.pixels, Rgb(1.0F));
  int top = 0;
  for (const SheetRow& row : rows) {
    paste(row.panorama, 0, top, sheet);
    paste(row.view, panorama.width + gap, top, sheet);
    top += pitch;
  }
  return sheet;
}

/// The rows of the scenes finished before `stop`.
std::vector<SheetRow> render_rows(const std::vector<SceneSource>& sources,
                                  const RenderSettings& settings, const std::stop_token& stop) {
  std::vector<SheetRow> rows;
  for (const SceneSource& source : sources) {
    print_text("scene {} of {}: {}, all around and one view\n", rows.size() + 1, sources.size(),
               source.title);
    std::fflush(stdout);
    SheetRow row = render_row(source, settings, stop);
    if (stop.stop_requested()) {
      break;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

RenderSettings settings_from(const SheetArguments& arguments) {
  RenderSettings settings = arguments.settings;
  settings.exposure = exposure_choice(arguments.look);
  settings.budget.samples = static_cast<std::uint64_t>(arguments.samples_per_pixel) *
                            static_cast<std::uint64_t>(settings.progressive.film_size.x) *
                            static_cast<std::uint64_t>(settings.progressive.film_size.y);
  return settings;
}

void make_sheet(const SheetArguments& arguments, const SceneFinder& find_scene,
                const std::stop_token& stop) {
  const RenderSettings settings = settings_from(arguments);
  require_image_extension(arguments.output);
  require_writable(arguments.output);
  const std::vector<SceneSource> sources = transformed(
      arguments.scenes,
      [&](const std::string& name) { return lit_scene(name, arguments.look, find_scene); });
  const std::vector<SheetRow> rows = render_rows(sources, settings, stop);
  if (rows.empty()) {
    throw Error(arguments.output, "is not written: no scene was finished", "let it run longer");
  }
  write_image(arguments.output, contact_sheet(rows), 0.0, tone_curve(arguments.look));
  print_text("{}: {} of {} scenes\n", arguments.output, rows.size(), sources.size());
}

}  // namespace

void add_scene_sheet(CLI::App& scene, const std::vector<std::string>& scenes,
                     const SceneFinder& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<SheetArguments>();
  arguments->scenes = scenes;
  CLI::App* command =
      scene.add_subcommand("sheet", "Make a contact sheet: each scene all around, and in one view");
  command->add_option("SCENE", arguments->scenes,
                      "Scenes' names or files (default: the built-in ones)");
  command->add_option("-o,--output", arguments->output, "The .png or .exr file to write")
      ->required();
  add_film_size_option(*command, arguments->settings.progressive.film_size);
  command->add_option("--spp", arguments->samples_per_pixel, "Samples per pixel of that image")
      ->check(CLI::Range(1, 1'000'000));
  add_threads_option(*command, arguments->settings.threads);
  add_light_options(*command, arguments->look);
  add_exposure_option(*command, arguments->look);
  add_tone_option(*command, arguments->look);
  command->footer("Example: foveola scene sheet -o sheet.png --size 512x256 --spp 64");
  command->callback([arguments, find_scene, stop] { make_sheet(*arguments, find_scene, stop); });
}

}  // namespace foveola
