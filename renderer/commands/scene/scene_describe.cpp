#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/command_line/common_options.h"
#include "renderer/command_line/output_options.h"
#include "renderer/commands/commands.h"
#include "renderer/commands/look_options.h"
#include "renderer/commands/scene/object_sheet.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/exposure.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/progressive/picture.h"
#include "renderer/progressive/proposed_objects.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

/// The command line, as typed.
struct DescribeArguments {
  std::string file;
  std::string output;
  std::string contact_sheet;
  LookArguments look;
  bool may_replace = false;
  int threads = 0;
};

/// The output files.
struct Outputs {
  fs::path descriptor;
  fs::path sheet;
};

Outputs outputs_of(const DescribeArguments& arguments) {
  Outputs outputs{.descriptor = arguments.output, .sheet = arguments.contact_sheet};
  if (outputs.descriptor.empty()) {
    outputs.descriptor = fs::path(arguments.file).replace_extension(".toml");
  } else if (outputs.descriptor.extension() != ".toml") {
    throw UsageError("--output", "a descriptor's name ends in .toml", "name it so");
  }
  if (outputs.sheet.empty()) {
    outputs.sheet = outputs.descriptor;
    outputs.sheet.replace_filename(outputs.descriptor.stem().string() + "-objects.png");
  }
  guard_output("--output", outputs.descriptor);
  guard_output("--contact-sheet", outputs.sheet);
  return outputs;
}

/// Called before the work: throws if an output cannot be written.
void require_free(const Outputs& outputs, bool may_replace) {
  require_image_extension(outputs.sheet);
  for (const fs::path& file : {outputs.descriptor, outputs.sheet}) {
    std::error_code ignored;
    if (fs::exists(file, ignored) && !may_replace) {
      throw Error(file.string(), "exists already", "add --force to replace it");
    }
    require_writable(file);
  }
}

/// The file alone, without its descriptor: a new one is made.
SceneSource source_of_file(const std::string& file) {
  SceneSource source;
  source.name = file;
  source.file = file;
  source.title = source.file.stem().string();
  return source;
}

/// An object's remark in the descriptor, and its line on the terminal.
std::string remark_on(const ProposedObject& proposed) {
  return fmt::format("{:.0f} % of it visible, {:.3g} m away", 100.0 * proposed.visible_share,
                     proposed.distance_m);
}

void print_result(const Outputs& outputs, const std::vector<ProposedObject>& objects) {
  print_text("{}: {} {} to choose from\n", outputs.descriptor.string(), objects.size(),
             objects.size() == 1 ? "object" : "objects");
  for (std::size_t i = 0; i < objects.size(); ++i) {
    print_text("{:>3}  {}: radius {:.1f} degrees, {}\n", i + 1, printable(objects[i].object.name),
               objects[i].object.radius_deg, remark_on(objects[i]));
  }
  if (objects.empty()) {
    print_text(
        "No object of the scene has a suitable size and visibility; 'foveola scene pick' gives "
        "positions for [[object]] entries of your own.\n");
  } else {
    print_text("{}: a picture of each\n", outputs.sheet.string());
  }
}

/// Sets the camera's properties for ordinary pictures, as far as a descriptor has them.
void describe_picture(const CameraView& camera, SceneSource& source) {
  source.camera_roll_rad = camera.roll_rad;
  if (camera.vertical_fov_rad) {
    source.camera_vertical_fov_rad =
        std::clamp(*camera.vertical_fov_rad, radians(narrowest_camera_fov_deg),
                   radians(widest_camera_fov_deg));
  }
  if (camera.aspect_ratio) {
    source.camera_aspect_ratio =
        std::clamp(*camera.aspect_ratio, least_camera_aspect_ratio, largest_camera_aspect_ratio);
  }
}

/// Sets the descriptor's camera, field of view and exposure, whoever chose them.
void describe_view(const LoadedScene& loaded, const ExposureChoice& exposure,
                   const Workers& workers, SceneSource& source) {
  source.camera_position = Vec3(DVec3(loaded.camera.position) + loaded.scene.origin);
  source.heading = loaded.camera.heading;
  describe_picture(loaded.camera, source);
  source.described_sha256 = loaded.scene.sha256;
  const Viewport view = viewport_of(loaded.camera, picture_of(loaded.camera, {}).field_of_view);
  source.exposure_stops = std::clamp(chosen_exposure(exposure, loaded, view, {}, workers).stops,
                                     -max_exposure_stops, max_exposure_stops);
}

/// Files named by a descriptor must be in its folder.
void print_what_belongs_beside(const fs::path& descriptor, const SceneSource& source) {
  const auto folder_of = [](const fs::path& file) { return fs::absolute(file).parent_path(); };
  std::vector<fs::path> files{source.file};
  if (source.environment_file) {
    files.push_back(*source.environment_file);
  }
  for (const fs::path& file : files) {
    std::error_code ignored;
    if (!fs::equivalent(folder_of(file), folder_of(descriptor), ignored)) {
      print_text(stderr, "foveola: note: {} belongs into the folder of {}\n", file.string(),
                 descriptor.string());
    }
  }
}

void describe(const DescribeArguments& arguments, SceneSource source,
              const DescriptorText& descriptor_text, const std::stop_token& stop) {
  if (source.time_s) {
    throw UsageError("--time", "a descriptor has no time of animations",
                     "describe the scene without it, and give it to foveola render");
  }
  const Outputs outputs = outputs_of(arguments);
  require_free(outputs, arguments.may_replace);
  apply_light(arguments.look, source);
  const Workers workers(arguments.threads);
  const LoadedScene loaded = load_or_exit(
      stop, [&] { return LoadedScene(source, workers, scene_choices(arguments.look)); });
  print_warnings(loaded.warnings);
  describe_view(loaded, exposure_choice(arguments.look), workers, source);
  const std::vector<ProposedObject> objects = propose_objects(loaded, workers);
  std::vector<std::string> remarks;
  for (const ProposedObject& proposed : objects) {
    source.objects.push_back(proposed.object);
    remarks.push_back(remark_on(proposed));
  }
  const std::string text = descriptor_text(source, remarks);
  if (objects.empty()) {
    fs::remove(outputs.sheet);  // an earlier one, which would show other objects
  } else {
    write_image(outputs.sheet, object_sheet(loaded, source, *source.exposure_stops, workers, stop),
                0.0);
  }
  write_file(outputs.descriptor, text);
  print_result(outputs, objects);
  print_what_belongs_beside(outputs.descriptor, source);
}

}  // namespace

void add_scene_describe(CLI::App& scene, const DescriptorText& descriptor_text,
                        const std::stop_token& stop) {
  const auto arguments = std::make_shared<DescribeArguments>();
  CLI::App* command =
      scene.add_subcommand("describe",
                           "Write a descriptor of your own scene: its camera, its exposure, and "
                           "objects in view that a study's participants may choose");
  command->add_option("FILE", arguments->file, "A .glb, .gltf or .obj file")->required();
  command->add_option("-o,--output", arguments->output,
                      "The .toml file to write (default: beside FILE, under its name, where every "
                      "command finds it)");
  mark_output(command->add_option("--contact-sheet", arguments->contact_sheet,
                                  "The .png with a picture of each object (default: beside the "
                                  "descriptor, NAME-objects.png)"));
  command->add_flag("--force", arguments->may_replace, "Replace existing files");
  add_viewpoint_options(*command, arguments->look);
  add_light_options(*command, arguments->look);
  add_exposure_option(*command, arguments->look);
  add_threads_option(*command, arguments->threads);
  command->footer("Example: foveola scene describe kitchen.glb");
  command->callback([arguments, descriptor_text, stop] {
    describe(*arguments, source_of_file(arguments->file), descriptor_text, stop);
  });
}

}  // namespace foveola
