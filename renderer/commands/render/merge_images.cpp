#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/commands.h"
#include "renderer/commands/render/film_parts.h"
#include "renderer/image/image_file.h"

namespace foveola {
namespace {

struct MergeArguments {
  std::vector<std::string> parts;
  std::string output;
  bool json = false;
};

void run_merge(const MergeArguments& arguments) {
  require_image_extension(arguments.output);
  require_writable(arguments.output);
  const Workers workers(0);
  MergedRender merge = merged({arguments.parts.begin(), arguments.parts.end()}, workers);
  ImageFacts& facts = merge.identity.facts;
  facts["foveola:samples"] = fmt::format("{}", merge.samples);
  write_film_image(arguments.output, merge.image, merge.identity.exposure_stops, facts,
                   merge.identity.curve);
  if (arguments.json) {
    const nlohmann::json json = {
        {"output", arguments.output},       {"parts", merge.parts},
        {"width", merge.image.color.width}, {"height", merge.image.color.height},
        {"samples", merge.samples},         {"non_finite", merge.non_finite}};
    print_text("{}\n", json.dump(2));
    return;
  }
  print_text("{}: {}x{}, {} samples of {} parts\n", arguments.output, merge.image.color.width,
             merge.image.color.height, merge.samples, merge.parts);
}

}  // namespace

void add_merge_images(CLI::App& app) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command = app.add_subcommand(
      "merge-images", "Merge the parts of a render, made by render --shard, into one image");
  command->add_option("PART", arguments->parts, "The .film of each part, in any order")->required();
  command->add_option("-o,--output", arguments->output, "The image to write, as .exr, .png or .jpg")
      ->required();
  add_json_option(*command, arguments->json);
  command->footer(
      "Example: foveola render arcade --shard 1/2 -o 1.film (and 2/2, elsewhere), then\n"
      "         foveola merge-images 1.film 2.film -o arcade.exr");
  command->callback([arguments] { run_merge(*arguments); });
}

}  // namespace foveola
