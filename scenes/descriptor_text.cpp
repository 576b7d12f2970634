#include "scenes/descriptor_text.h"

#include <cassert>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/text/utf8.h"
#include "scenes/descriptor.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

/// JSON's escapes are TOML's too. Invalid UTF-8 is replaced.
std::string quoted(const std::string& text) {
  constexpr int on_one_line = -1;
  return nlohmann::json(printable(text))
      .dump(on_one_line, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Quotes the name of a file, which must be exact. Throws Error.
std::string quoted_name(const fs::path& file) {
  const std::string name = file.filename().string();
  std::string text = quoted(name);
  if (nlohmann::json::parse(text).get<std::string>() != name) {
    throw Error(file.string(), "has a name with characters that a descriptor cannot contain",
                "give it a name in UTF-8 without control characters");
  }
  return text;
}

/// Twelve digits hide the rounding of angles; adding 0 removes -0.
std::string number(double value) { return fmt::format("{:.12g}", value + 0.0); }

/// Enough digits to distinguish it from any other float.
std::string number(float value) { return fmt::format("{}", value + 0.0F); }

/// Returns the azimuth of a direction, in degrees from -180 to 180.
std::string azimuth(double angle_rad) { return number(std::remainder(degrees(angle_rad), 360.0)); }

std::string list_of(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z));
}

/// In the file's units.
std::string position_of(const Vec3& metres, const SceneSource& source) {
  return list_of(Vec3(DVec3(metres) / source.metres_per_unit));
}

std::string facts_of_file(const SceneSource& source) {
  std::string text =
      fmt::format("title = {}\nfile = {}\n", quoted(source.title), quoted_name(source.file));
  if (!source.described_sha256.empty()) {
    text += fmt::format("sha256 = \"{}\"\n", source.described_sha256);
  }
  if (source.metres_per_unit != 1.0) {
    text += fmt::format("metres_per_unit = {}\n", number(source.metres_per_unit));
  }
  if (source.light_units) {
    text += fmt::format("light_units = \"{}\"\n", word_for(light_unit_words, *source.light_units));
  }
  return text;
}

std::string light_sizes_of(const SceneSource& source) {
  std::string text;
  if (source.light_radius_m) {
    text +=
        fmt::format("light_radius = {}\n",
                    number(static_cast<float>(*source.light_radius_m / source.metres_per_unit)));
  }
  if (source.sun_angular_radius_rad) {
    text += fmt::format("sun_radius_deg = {}\n",
                        number(static_cast<float>(degrees(*source.sun_angular_radius_rad))));
  }
  return text;
}

/// Returns the environment without the sky, a table that must come last.
std::string environment_of(const SceneSource& source) {
  std::string text;
  if (source.environment_radiance) {
    text += fmt::format("environment_radiance = {}\n", list_of(*source.environment_radiance));
  }
  if (source.environment_file) {
    text += fmt::format("environment_file = {}\n", quoted_name(*source.environment_file));
  }
  if (source.environment_strength != 1.0) {
    text += fmt::format("environment_strength = {}\n", number(source.environment_strength));
  }
  if (source.environment_rotation_rad != 0.0) {
    text += fmt::format("environment_rotation_deg = {}\n",
                        number(std::fmod(degrees(source.environment_rotation_rad), 360.0)));
  }
  return text;
}

std::string table_of(const SunAndSky& sky) {
  return fmt::format(
      "\n[sky]\nsun_azimuth_deg = {}\nsun_elevation_deg = {}\nturbidity = {}\nground_albedo = {}\n",
      azimuth(sky.sun.azimuth_rad), number(degrees(sky.sun.elevation_rad)), number(sky.turbidity),
      number(sky.ground_albedo));
}

std::string camera_of(const SceneSource& source) {
  std::string text =
      fmt::format("\n[camera]\nposition = {}\nazimuth_deg = {}\nelevation_deg = {}\n",
                  position_of(*source.camera_position, source), azimuth(source.heading.azimuth_rad),
                  number(degrees(source.heading.elevation_rad)));
  if (source.camera_roll_rad != 0.0) {
    text += fmt::format("roll_deg = {}\n", number(degrees(source.camera_roll_rad)));
  }
  if (source.camera_vertical_fov_rad) {
    text +=
        fmt::format("vertical_fov_deg = {}\n", number(degrees(*source.camera_vertical_fov_rad)));
  }
  if (source.camera_aspect_ratio) {
    text += fmt::format("aspect_ratio = {}\n", number(*source.camera_aspect_ratio));
  }
  return text;
}

std::string text_of(const SceneSource& source, const std::vector<std::string>& remarks) {
  std::string text = facts_of_file(source);
  if (source.exposure_stops) {
    text += fmt::format("exposure_stops = {}\n", number(*source.exposure_stops));
  }
  text += light_sizes_of(source);
  text += environment_of(source);
  text += source.sky ? table_of(*source.sky) : "";
  text += camera_of(source);
  for (std::size_t i = 0; i < source.objects.size(); ++i) {
    const ObjectOfInterest& object = source.objects[i];
    const std::string remark = remarks.empty() ? "" : fmt::format("  # {}", printable(remarks[i]));
    text +=
        fmt::format("\n[[object]]{}\nname = {}\nposition = {}\nradius_deg = {:.3g}\n", remark,
                    quoted(object.name), position_of(object.position, source), object.radius_deg);
  }
  return text;
}

/// Throws Error for everything that read_descriptor() refuses, except an image that may be put
/// beside the descriptor later.
void require_accepted(SceneSource source) {
  source.environment_file.reset();
  parse_descriptor(source.file.filename().replace_extension(".toml"), text_of(source, {}));
}

}  // namespace

std::string descriptor_text(const SceneSource& source, const std::vector<std::string>& remarks) {
  assert(source.camera_position && (remarks.empty() || remarks.size() == source.objects.size()));
  require_accepted(source);
  return text_of(source, remarks);
}

}  // namespace foveola::scenes
