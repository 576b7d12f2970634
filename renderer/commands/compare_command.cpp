#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/commands.h"
#include "renderer/gaze/profiles.h"
#include "renderer/image/image_file.h"
#include "renderer/measure/flip.h"
#include "renderer/measure/region_error.h"
#include "renderer/vision/fov_video_vdp.h"

namespace foveola {
namespace {

struct CompareArguments {
  std::string image;
  std::string reference;
  bool solid_angle = false;
  double pixels_per_degree = 0.0;  ///< 0: the display's
  std::string display;
  std::vector<double> fixation_px;  ///< x and y; empty: no foveation
  bool json = false;
};

/// Default white luminance of profiles without a measurement.
constexpr double assumed_white_cd_m2 = 100.0;
/// Default contrast of profiles without a measurement.
constexpr double assumed_contrast = 1000.0;

/// The visible difference.
struct SeenDifference {
  double pixels_per_degree = 0.0;
  double flip = 0.0;               ///< mean of the pixels
  std::optional<double> hdr_flip;  ///< of radiances
  std::optional<double> jod;       ///< on a display
  VdpDisplay display;
};

/// One view of a display, filled by a picture.
VdpDisplay vdp_display(const DisplayProfile& profile) {
  if (profile.kind == DisplayKind::openxr) {
    throw Error("--display " + profile.name, "has no size of its own: its runtime states it",
                "name the profile of a monitor or of a headset");
  }
  const int width_px =
      profile.kind == DisplayKind::headset ? profile.width_px / 2 : profile.width_px;
  const DVec2 fov_rad(radians(profile.horizontal_fov_deg), radians(profile.vertical_fov_deg));
  const MeasuredDisplay measured = profile.measured.value_or(MeasuredDisplay{});
  const double white_cd_m2 = measured.white_cd_m2.value_or(assumed_white_cd_m2);
  return {.pixels_per_degree = pixels_per_degree(fov_rad.x, width_px),
          .half_size = Vec2(std::tan(0.5 * fov_rad.x), std::tan(0.5 * fov_rad.y)),
          .white_cd_m2 = white_cd_m2,
          .black_cd_m2 = measured.black_cd_m2.value_or(white_cd_m2 / assumed_contrast)};
}

double mean(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

SeenDifference seen_difference(const CompareArguments& arguments, const RgbImage& image,
                               const RgbImage& reference) {
  SeenDifference seen;
  if (!arguments.display.empty()) {
    seen.display = vdp_display(read_display_profile(arguments.display));
  }
  seen.pixels_per_degree = arguments.pixels_per_degree > 0.0 ? arguments.pixels_per_degree
                                                             : seen.display.pixels_per_degree;
  const RgbImage shown = display_image(image, 0.0);
  const RgbImage shown_reference = display_image(reference, 0.0);
  seen.flip = mean(flip_errors(shown, shown_reference, seen.pixels_per_degree));
  if (holds_radiance(arguments.image) && holds_radiance(arguments.reference)) {
    seen.hdr_flip = mean(hdr_flip_errors(image, reference, seen.pixels_per_degree));
  }
  if (!arguments.display.empty()) {
    std::optional<Vec2> fixation_px;
    if (!arguments.fixation_px.empty()) {
      fixation_px = Vec2(arguments.fixation_px[0], arguments.fixation_px[1]);
    }
    const Workers workers;
    FovVideoVdp vdp(seen.display, {image.width, image.height}, fixation_px, std::nullopt, workers);
    vdp.add(shown, shown_reference);
    seen.jod = vdp.jod();
  }
  return seen;
}

nlohmann::json json_of(const SeenDifference& seen, const CompareArguments& arguments) {
  nlohmann::json json = {{"pixels_per_degree", seen.pixels_per_degree}, {"flip", seen.flip}};
  if (seen.hdr_flip) {
    json["hdr_flip"] = *seen.hdr_flip;
  }
  if (seen.jod) {
    json["jod"] = *seen.jod;
    json["display"] = arguments.display;
    json["white_cd_m2"] = seen.display.white_cd_m2;
    json["black_cd_m2"] = seen.display.black_cd_m2;
    if (!arguments.fixation_px.empty()) {
      json["fixation_px"] = arguments.fixation_px;
    }
  }
  return json;
}

void print(const SeenDifference& seen, const CompareArguments& arguments) {
  print_text("FLIP {:.6f}", seen.flip);
  if (seen.hdr_flip) {
    print_text(", HDR-FLIP {:.6f}", *seen.hdr_flip);
  }
  print_text(" at {:.6g} pixels per degree\n", seen.pixels_per_degree);
  if (seen.jod) {
    const std::vector<double>& fixation = arguments.fixation_px;
    print_text("FovVideoVDP {:.4f} JOD on {} of {:g} cd/m2, {}\n", *seen.jod, arguments.display,
               seen.display.white_cd_m2,
               fixation.empty() ? "not foveated"
                                : fmt::format("looking at {:g},{:g}", fixation[0], fixation[1]));
  }
}

void run_compare(const CompareArguments& arguments) {
  const FilmImage image = read_film_image(arguments.image);
  const FilmImage reference = read_film_image(arguments.reference);
  const ErrorMetrics metrics =
      compare_images(image.color, reference.color,
                     arguments.solid_angle ? PixelWeight::solid_angle : PixelWeight::uniform);
  std::optional<SeenDifference> seen;
  if (arguments.pixels_per_degree > 0.0 || !arguments.display.empty()) {
    seen = seen_difference(arguments, image.color, reference.color);
  }
  if (arguments.json) {
    nlohmann::json json = {{"rmse", metrics.rmse},
                           {"relative_mse", metrics.relative_mse},
                           {"relative_mse_epsilon", relative_mse_epsilon},
                           {"mean_image", metrics.mean_image},
                           {"mean_reference", metrics.mean_reference},
                           {"pixels", metrics.pixels},
                           {"non_finite", metrics.non_finite}};
    if (seen) {
      json.update(json_of(*seen, arguments));
    }
    print_text("{}\n", json.dump(2));
    return;
  }
  print_text(
      "RMSE {:.6g}, relative MSE {:.6g} (epsilon {}), mean {:.6g} against {:.6g}, "
      "{} pixels, {} non-finite\n",
      metrics.rmse, metrics.relative_mse, relative_mse_epsilon, metrics.mean_image,
      metrics.mean_reference, metrics.pixels, metrics.non_finite);
  if (seen) {
    print(*seen, arguments);
  }
}

}  // namespace

void add_compare(CLI::App& app) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "Measure the error of an image against a reference");
  command->add_option("IMAGE", arguments->image, "An image file")->required();
  command->add_option("REFERENCE", arguments->reference, "An image file of the same size")
      ->required();
  command->add_flag("--solid-angle", arguments->solid_angle,
                    "Weight pixels by their solid angle: the cosine of their latitude");
  command
      ->add_option("--pixels-per-degree", arguments->pixels_per_degree,
                   "Also measure FLIP at this density, and HDR-FLIP of two .exr files; of views, "
                   "not of 360-degree images (default: the display's)")
      ->check(CLI::Range(0.1, 1000.0));
  CLI::Option* display =
      command->add_option("--display", arguments->display,
                          "Measure FLIP and FovVideoVDP on the display of this profile, which the "
                          "image covers. Its white "
                          "has 100 cd/m2 unless it was measured; an .exr is shown with exposure 0");
  command
      ->add_option("--fixation", arguments->fixation_px,
                   "Fixation: x,y in pixels from the upper left corner (default: everywhere)")
      ->delimiter(',')
      ->expected(2)
      ->needs(display);
  add_json_option(*command, arguments->json);
  command->footer(
      "Example: foveola compare view.png reference.png --display desktop --fixation 320,240");
  command->callback([arguments] { run_compare(*arguments); });
}

}  // namespace foveola
