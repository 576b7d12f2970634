#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/commands.h"
#include "renderer/commands/look_options.h"
#include "renderer/commands/scene_file_options.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {
namespace {

struct PickArguments {
  std::string scene;
  std::string gaze;
  LookArguments look;
  bool json = false;
};

/// The hit in the file's own world.
struct Answer {
  std::string object;
  std::string material;
  DVec3 position;
  float distance_m;
};

std::optional<Answer> pick(const PickArguments& arguments, const SceneSource& source,
                           const std::stop_token& stop) {
  RenderSettings settings;
  if (!arguments.gaze.empty()) {
    settings.gaze = parse_azimuth_elevation("--gaze", arguments.gaze);
  }
  settings.scene = scene_choices(arguments.look);
  settings.scene.learns_lights = false;  // no light is traced
  const Workers workers;
  const LoadedScene loaded =
      load_or_exit(stop, [&] { return LoadedScene(source, workers, settings.scene); });
  print_warnings(loaded.warnings);
  const auto picked =
      loaded.tracer.pick(loaded.camera.position, direction_from(gaze_of(settings, loaded)));
  if (!picked) {
    return std::nullopt;
  }
  return Answer{.object = loaded.scene.object_name(picked->object),
                .material = loaded.scene.materials[static_cast<std::size_t>(picked->material)].name,
                .position = DVec3(picked->position) + loaded.scene.origin,
                .distance_m = picked->distance_m};
}

void print(const std::optional<Answer>& answer, bool as_json) {
  if (as_json) {
    nlohmann::json json;
    if (answer) {
      json = {{"object", answer->object},
              {"material", answer->material},
              {"position", {answer->position.x, answer->position.y, answer->position.z}},
              {"distance_m", answer->distance_m}};
    }
    print_text("{}\n", json.dump(2));
  } else if (answer) {
    print_text("'{}' of '{}' at ({:.6g}, {:.6g}, {:.6g}), {:.6g} m away\n",
               printable(answer->object), printable(answer->material), answer->position.x,
               answer->position.y, answer->position.z, answer->distance_m);
  } else {
    print_text("nothing\n");
  }
}

}  // namespace

void add_scene_pick(CLI::App& scene, const SceneFinder& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<PickArguments>();
  CLI::App* command = scene.add_subcommand(
      "pick", "Print the first object that a gaze hits, its material, and the place");
  add_scene_option(*command, arguments->scene);
  command->add_option(
      "--gaze", arguments->gaze,
      "Gaze: azimuth,elevation in degrees in the world (default: the head's direction)");
  add_viewpoint_options(*command, arguments->look);
  command->add_flag("--json", arguments->json, "Print it as JSON; null if nothing is hit");
  command->footer("Example: foveola scene pick arcade --gaze 78,-9");
  command->callback([arguments, stop, find = with_scene_file_options(*command, find_scene)] {
    print(pick(*arguments, find(arguments->scene), stop), arguments->json);
  });
}

}  // namespace foveola
