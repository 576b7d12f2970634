// The options of every command that shows a scene: viewpoint, light and exposure.
#pragma once

#include <optional>
#include <string>

#include "renderer/base/scene_source.h"
#include "renderer/command_line/cli_fwd.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/scene_file_options.h"
#include "renderer/image/image_file.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/progressive/exposure.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/trace/paths/path_tracer.h"

namespace foveola {

/// As typed; empty or nullopt if the option was not given.
struct LookArguments {
  std::string camera;
  std::string head;
  std::string fov;
  std::string environment;
  double environment_rotation_deg = 0.0;
  double environment_strength = 1.0;
  SceneFileArguments file;
  std::optional<double> light_radius_m;
  std::optional<double> sun_radius_deg;
  std::string exposure;
  std::string tone = "plain";
};

/// --camera and --head.
void add_viewpoint_options(CLI::App& command, LookArguments& arguments);
/// --fov. otherwise: the default, for the help.
void add_fov_option(CLI::App& command, LookArguments& arguments, const std::string& otherwise);
/// --environment, --environment-rotation, --environment-strength, --light-radius, --sun-radius and
/// what add_scene_file_options adds.
void add_light_options(CLI::App& command, LookArguments& arguments);
/// --exposure.
void add_exposure_option(CLI::App& command, LookArguments& arguments);
/// --tone.
void add_tone_option(CLI::App& command, LookArguments& arguments);

/// --size of the film, in pixels.
void add_film_size_option(CLI::App& command, IVec2& size);
/// --max-depth and --seed.
void add_path_options(CLI::App& command, TraceSettings& trace);

/// The viewpoint by --camera and --head. Throws UsageError.
SceneChoices scene_choices(const LookArguments& arguments);

/// nullopt without --fov. Throws UsageError.
std::optional<FieldsOfView> fields_of_view(const LookArguments& arguments);

/// Applies the light options to the scene. Throws UsageError, and Error for an environment's file
/// that does not exist.
void apply_light(const LookArguments& arguments, SceneSource& source);

/// The scene of this name or path with these light options. Throws Error as find_scene and
/// apply_light do.
SceneSource lit_scene(const std::string& name_or_path, const LookArguments& arguments,
                      const SceneFinder& find_scene);

/// Throws UsageError.
ExposureChoice exposure_choice(const LookArguments& arguments);

ToneCurve tone_curve(const LookArguments& arguments);

/// The typed options of light and time, for the header of an image.
ImageFacts light_facts(const LookArguments& arguments);

}  // namespace foveola
