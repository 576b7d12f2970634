#include "renderer/commands/commands.h"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "renderer/base/print.h"
#include "renderer/command_line/common_options.h"
#include "renderer/image/image_file.h"
#include "renderer/measure/region_error.h"

namespace foveola {
namespace {

struct CompareArguments {
  std::string image;
  std::string reference;
  bool solid_angle = false;
  bool json = false;
};

void run_compare(const CompareArguments& arguments) {
  const FilmImage image = read_film_image(arguments.image);
  const FilmImage reference = read_film_image(arguments.reference);
  const ErrorMetrics metrics =
      compare_images(image.color, reference.color,
                     arguments.solid_angle ? PixelWeight::solid_angle : PixelWeight::uniform);
  if (arguments.json) {
    const nlohmann::json json = {{"rmse", metrics.rmse},
                                 {"relative_mse", metrics.relative_mse},
                                 {"relative_mse_epsilon", relative_mse_epsilon},
                                 {"mean_image", metrics.mean_image},
                                 {"mean_reference", metrics.mean_reference},
                                 {"pixels", metrics.pixels},
                                 {"non_finite", metrics.non_finite}};
    print_text("{}\n", json.dump(2));
  } else {
    print_text(
        "RMSE {:.6g}, relative MSE {:.6g} (epsilon {}), mean {:.6g} against {:.6g}, "
        "{} pixels, {} non-finite\n",
        metrics.rmse, metrics.relative_mse, relative_mse_epsilon, metrics.mean_image,
        metrics.mean_reference, metrics.pixels, metrics.non_finite);
  }
}

void add_compare(CLI::App& app) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand("compare", "Measure how far an image is from a reference");
  command->add_option("IMAGE", arguments->image, "An image file")->required();
  command->add_option("REFERENCE", arguments->reference, "An image file of the same size")
      ->required();
  command->add_flag("--solid-angle", arguments->solid_angle,
                    "Weight pixels by their solid angle: the cosine of their latitude");
  add_json_option(*command, arguments->json);
  command->footer("Example: foveola compare preview.exr reference.exr --solid-angle");
  command->callback([arguments] { run_compare(*arguments); });
}

}  // namespace

void add_renderer_commands(CLI::App& app, const SceneFinder& find_scene, std::stop_token stop) {
  add_render(app, find_scene, stop);
  add_merge_images(app);
  add_compare(app);
}

}  // namespace foveola
