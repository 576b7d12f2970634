#include "renderer/commands/look_options.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/text/words.h"
#include "renderer/command_line/common_options.h"

namespace foveola {
namespace {

constexpr std::array tone_curves{Word<ToneCurve>{"plain", ToneCurve::plain},
                                 Word<ToneCurve>{"filmic", ToneCurve::filmic}};

/// The help text of --environment.
constexpr const char* environment_help =
    "Environment of the scene: a lat-long image file, r,g,b for a constant radiance, or "
    "sky:AZIMUTH,ELEVATION[,TURBIDITY] for daylight with the sun there (degrees)";

/// Replaces the environment of `source` by that of `text`: "r,g,b" is a constant radiance,
/// "sky:..." daylight, anything else a file, which is not read yet. The descriptor's settings of
/// its own environment are dropped. Throws UsageError, and Error for a file that does not exist.
void replace_environment(const std::string& text, SceneSource& source) {
  constexpr std::string_view sky = "sky:";
  source.environment_radiance.reset();
  source.environment_file.reset();
  source.sky.reset();
  source.suns.clear();
  source.environment_strength = 1.0;
  source.environment_rotation_rad = 0.0;
  if (text.starts_with(sky)) {
    source.sky = parse_sky("--environment", text.substr(sky.size()));
  } else if (std::ranges::count(text, ',') == 2) {
    const Rgb radiance = parse_vec3("--environment", text);
    if (!glm::all(glm::greaterThanEqual(radiance, Rgb(0.0F)))) {
      throw UsageError("--environment", "radiance must not be negative",
                       "give r,g,b of 0 or more, for instance 1,1,1");
    }
    source.environment_radiance = radiance;
  } else if (!std::filesystem::exists(text)) {
    throw Error(text, "does not exist",
                "give --environment r,g,b, sky:AZIMUTH,ELEVATION or a lat-long image file");
  } else {
    source.environment_file = text;
  }
}

/// Whether the text of --camera is a place: names rarely begin like a number and have a comma.
bool is_place(const std::string& camera) {
  return camera.find(',') != std::string::npos &&
         std::string_view("+-.0123456789").find(camera.front()) != std::string_view::npos;
}

/// A number of stops, with a sign or without.
double parse_stops(const std::string& text, std::string_view number) {
  if (number.starts_with('+')) {
    number.remove_prefix(1);
  }
  const std::optional<double> stops = parse_finite_number(number);
  if (!stops || std::abs(*stops) > max_exposure_stops) {
    throw UsageError("--exposure", fmt::format("'{}' is not an exposure", text),
                     fmt::format("give stops from {:g} to {:g}, auto, auto+1, auto-1, or fixed:2",
                                 -max_exposure_stops, max_exposure_stops));
  }
  return *stops;
}

}  // namespace

void add_viewpoint_options(CLI::App& command, LookArguments& arguments) {
  command.add_option("--camera", arguments.camera, camera_help);
  command.add_option("--head", arguments.head,
                     "Direction of the camera or the head: azimuth,elevation in degrees, azimuth "
                     "from -Z towards +X (default: the scene's heading)");
}

void add_fov_option(CLI::App& command, LookArguments& arguments, const std::string& otherwise) {
  command.add_option(
      "--fov", arguments.fov,
      fmt::format("Field of view in degrees: WIDTH, or WIDTHxHEIGHT (default: {})", otherwise));
}

void add_light_options(CLI::App& command, LookArguments& arguments) {
  command.add_option("--environment", arguments.environment, environment_help);
  command.add_option("--environment-rotation", arguments.environment_rotation_deg,
                     "Rotate the environment by this angle in degrees, from -Z towards +X");
  command.add_option("--environment-strength", arguments.environment_strength,
                     "Multiply the environment's radiance by this");
  add_scene_file_options(command, arguments.file);
  command.add_option("--light-radius", arguments.light_radius_m,
                     "Turn the file's point and spot lights into spheres of this radius in metres");
  command.add_option("--sun-radius", arguments.sun_radius_deg,
                     "Turn directional lights into discs of this angular radius in degrees");
}

void add_exposure_option(CLI::App& command, LookArguments& arguments) {
  command.add_option("--exposure", arguments.exposure,
                     "Exposure: STOPS added to the scene's own, or to the automatic one if it has "
                     "none; auto, auto+STOPS or auto-STOPS: automatic, whatever the scene has; "
                     "fixed:STOPS: exactly this. Radiances in an .exr do not change");
}

void add_tone_option(CLI::App& command, LookArguments& arguments) {
  command
      .add_option("--tone", arguments.tone,
                  "Tone curve: plain (clipped at white) or filmic (compressed towards white)")
      ->check(CLI::IsMember(texts_of(tone_curves)));
}

void add_film_size_option(CLI::App& command, IVec2& size) {
  command
      .add_option_function<std::string>(
          "--size", [&size](const std::string& text) { size = parse_size("--size", text); },
          "Size of the film in pixels, WIDTHxHEIGHT")
      ->default_str(size_text(size));
}

void add_path_options(CLI::App& command, TraceSettings& trace) {
  add_max_depth_option(command, trace.max_depth);
  command
      .add_option("--seed", trace.seed,
                  "Seed of the random numbers; another seed gives other noise")
      ->check(CLI::Range(std::uint32_t{0}, std::numeric_limits<std::uint32_t>::max()));
}

SceneChoices scene_choices(const LookArguments& arguments) {
  SceneChoices choices;
  if (!arguments.camera.empty()) {
    if (is_place(arguments.camera)) {
      choices.camera = parse_vec3("--camera", arguments.camera);
    } else {
      choices.camera_name = arguments.camera;
    }
  }
  if (!arguments.head.empty()) {
    choices.head = parse_azimuth_elevation("--head", arguments.head);
  }
  return choices;
}

std::optional<FieldsOfView> fields_of_view(const LookArguments& arguments) {
  return arguments.fov.empty() ? std::nullopt
                               : std::optional(parse_fields_of_view("--fov", arguments.fov));
}

void apply_light(const LookArguments& arguments, SceneSource& source) {
  if (!arguments.environment.empty()) {
    replace_environment(arguments.environment, source);
  }
  source.environment_rotation_rad += radians(arguments.environment_rotation_deg);
  source.environment_strength *= arguments.environment_strength;
  apply_scene_file_options(arguments.file, source);
  if (arguments.light_radius_m) {
    constexpr double max_radius_m = 1e6;  // as of a glTF file's lights
    if (!(*arguments.light_radius_m >= 0.0 && *arguments.light_radius_m <= max_radius_m)) {
      throw UsageError("--light-radius",
                       fmt::format("'{:g}' is not a radius", *arguments.light_radius_m),
                       fmt::format("give metres from 0 to {:g}", max_radius_m));
    }
    source.light_radius_m = static_cast<float>(*arguments.light_radius_m);
  }
  if (arguments.sun_radius_deg) {
    source.sun_angular_radius_rad = static_cast<float>(radians(*arguments.sun_radius_deg));
  }
}

SceneSource lit_scene(const std::string& name_or_path, const LookArguments& arguments,
                      const SceneFinder& find_scene) {
  SceneSource source = find_scene(name_or_path);
  apply_light(arguments, source);
  return source;
}

ExposureChoice exposure_choice(const LookArguments& arguments) {
  using Base = ExposureChoice::Base;
  constexpr std::string_view automatic = "auto";
  constexpr std::string_view fixed = "fixed:";
  const std::string& text = arguments.exposure;
  if (text.empty()) {
    return {};
  }
  std::string_view rest = text;
  if (text.starts_with(automatic)) {
    rest.remove_prefix(automatic.size());
    const bool has_sign = rest.starts_with('+') || rest.starts_with('-');
    return {.base = Base::automatic,
            .more_stops = rest.empty() ? 0.0 : parse_stops(text, has_sign ? rest : text)};
  }
  if (text.starts_with(fixed)) {
    rest.remove_prefix(fixed.size());
    return {.base = Base::none, .more_stops = parse_stops(text, rest)};
  }
  return {.base = Base::scene, .more_stops = parse_stops(text, rest)};
}

ToneCurve tone_curve(const LookArguments& arguments) {
  return value_of(tone_curves, arguments.tone);
}

ImageFacts light_facts(const LookArguments& arguments) {
  ImageFacts facts;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) {
      facts[fmt::format("foveola:{}", name)] = value;
    }
  };
  const auto text_of = [](double value, double usual) {
    return value == usual ? std::string() : fmt::format("{}", value);
  };
  add("environment", arguments.environment);
  add("environment-rotation", text_of(arguments.environment_rotation_deg, 0.0));
  add("environment-strength", text_of(arguments.environment_strength, 1.0));
  add("light-units", arguments.file.light_units);
  if (arguments.file.time_s) {
    add("time", fmt::format("{}", *arguments.file.time_s));
    add("clip", arguments.file.clip);
  }
  if (arguments.light_radius_m) {
    add("light-radius", fmt::format("{}", *arguments.light_radius_m));
  }
  if (arguments.sun_radius_deg) {
    add("sun-radius", fmt::format("{}", *arguments.sun_radius_deg));
  }
  return facts;
}

}  // namespace foveola
