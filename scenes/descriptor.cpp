#include "scenes/descriptor.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/toml/toml_file.h"
#include "renderer/base/toml/toml_reader.h"
#include "scenes/builtin.h"
#include "scenes/file_search.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

/// In the file's units, like the descriptor's positions.
constexpr double largest_coordinate = 1e6;
constexpr double largest_radiance = 1e6;

bool is_axis(const Vec3& v) {
  const Vec3 size = glm::abs(v);
  return size == Vec3(1, 0, 0) || size == Vec3(0, 1, 0) || size == Vec3(0, 0, 1);
}

bool is_digest(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// A plain name, without a folder, cannot lead reads or writes elsewhere.
bool is_plain_name(const fs::path& path) { return path.filename() == path; }

/// Reads a position in metres. Throws Error if the key is absent.
Vec3 read_position(TomlReader& table, std::string_view key, double metres_per_unit) {
  Vec3 position;
  table.read(required(key), position, -largest_coordinate, largest_coordinate);
  return static_cast<float>(metres_per_unit) * position;
}

RectangleLight read_light(TomlReader table, double metres_per_unit) {
  RectangleLight light;
  light.center = read_position(table, "center", metres_per_unit);
  table.read(required("size"), light.size, 1e-6, largest_coordinate);
  light.size *= static_cast<float>(metres_per_unit);
  table.read(required("normal"), light.normal, -1.0, 1.0);
  table.read(required("radiance"), light.radiance, 0.0, largest_radiance);
  if (!is_axis(light.normal)) {
    table.fail(table.source("normal"), "normal must be an axis", "for example [0, -1, 0]");
  }
  table.reject_unknown_keys();
  return light;
}

/// Reads the angles in degrees under these names; returns radians.
AzimuthElevation read_angles(TomlReader& table, std::string_view azimuth,
                             std::string_view elevation) {
  double azimuth_deg = 0.0;
  double elevation_deg = 0.0;
  table.read(required(azimuth), azimuth_deg, -180.0, 180.0);
  table.read(required(elevation), elevation_deg, -90.0, 90.0);
  return {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)};
}

Sun read_sun(TomlReader table) {
  Sun sun;
  sun.place = read_angles(table, "azimuth_deg", "elevation_deg");
  table.read(required("irradiance"), sun.irradiance, 0.0, largest_radiance);
  double angular_radius_deg = degrees(sun.angular_radius_rad);
  table.read("angular_radius_deg", angular_radius_deg, 0.0, 45.0);
  sun.angular_radius_rad = radians(angular_radius_deg);
  table.reject_unknown_keys();
  return sun;
}

ObjectOfInterest read_object(TomlReader table, double metres_per_unit) {
  ObjectOfInterest object;
  object.name = table.require_text("name");
  object.position = read_position(table, "position", metres_per_unit);
  double radius_deg = 0.0;
  table.read(required("radius_deg"), radius_deg, 0.1, 90.0);
  object.radius_deg = static_cast<float>(radius_deg);
  table.reject_unknown_keys();
  return object;
}

/// Throws Error if the last object cannot be distinguished from another, or is at the camera.
void require_choosable(const TomlReader& table, const SceneSource& source) {
  constexpr double least_distance = 1e-3;  // in the file's units
  const ObjectOfInterest& object = source.objects.back();
  const auto same_name = [&](const ObjectOfInterest& other) { return other.name == object.name; };
  if (std::ranges::count_if(source.objects, same_name) > 1) {
    table.fail(table.source("name"), "two objects are named \"" + object.name + "\"",
               "give each object a name of its own");
  }
  if (source.camera_position && glm::distance(object.position, *source.camera_position) <
                                    least_distance * source.metres_per_unit) {
    table.fail(table.source("position"), "the object's position is the camera's",
               "move the object or the camera");
  }
}

/// Reads the keys that only still pictures of the camera use.
void read_picture(TomlReader& table, SceneSource& source) {
  double roll_deg = 0.0;
  table.read("roll_deg", roll_deg, -180.0, 180.0);
  source.camera_roll_rad = radians(roll_deg);
  if (table.has("vertical_fov_deg")) {
    double fov_deg = 0.0;
    table.read("vertical_fov_deg", fov_deg, narrowest_camera_fov_deg, widest_camera_fov_deg);
    source.camera_vertical_fov_rad = radians(fov_deg);
  }
  table.read("aspect_ratio", source.camera_aspect_ratio, least_camera_aspect_ratio,
             largest_camera_aspect_ratio);
}

void read_camera(TomlReader table, SceneSource& source) {
  source.camera_position = read_position(table, "position", source.metres_per_unit);
  source.heading = read_angles(table, "azimuth_deg", "elevation_deg");
  read_picture(table, source);
  table.reject_unknown_keys();
}

SunAndSky read_sky(TomlReader table) {
  SunAndSky sky;
  sky.sun = read_angles(table, "sun_azimuth_deg", "sun_elevation_deg");
  table.read("turbidity", sky.turbidity, 2.0, 10.0);
  double ground_albedo = sky.ground_albedo;
  table.read("ground_albedo", ground_albedo, 0.0, 1.0);
  sky.ground_albedo = static_cast<float>(ground_albedo);
  table.reject_unknown_keys();
  return sky;
}

void read_light_units(TomlReader& table, SceneSource& source) {
  if (table.has("light_units")) {
    table.read("light_units", source.light_units.emplace(), light_unit_words);
  }
}

/// Reads an image in the descriptor's own folder, which may hold any files.
void read_environment_file(TomlReader& table, const fs::path& folder, SceneSource& source) {
  std::string name;
  table.read("environment_file", name);
  if (!table.has("environment_file")) {
    return;
  }
  try {
    source.environment_file = confined_path(folder, name);
  } catch (const std::runtime_error& reason) {
    table.fail(table.source("environment_file"), fmt::format("'{}': {}", name, reason.what()),
               "name an image in the folder of the descriptor");
  }
}

void require_one_environment(const TomlReader& table) {
  constexpr std::array keys{"environment_radiance", "environment_file", "sky"};
  const auto is_given = [&](const char* key) { return table.has(key); };
  if (std::ranges::count_if(keys, is_given) > 1) {
    const auto* const first = std::ranges::find_if(keys, is_given);
    table.fail(table.source(*std::find_if(first + 1, keys.end(), is_given)),
               "the scene has several environments",
               "use only one of environment_radiance, environment_file and [sky]");
  }
}

void read_light_from_outside(TomlReader& table, const fs::path& folder, SceneSource& source) {
  require_one_environment(table);
  read_environment_file(table, folder, source);
  if (table.has("environment_radiance")) {
    Rgb radiance;
    table.read("environment_radiance", radiance, 0.0, largest_radiance);
    source.environment_radiance = radiance;
  }
  table.read_table("sky", source.sky, read_sky);
  for (const TomlReader& sun : table.tables("sun")) {
    source.suns.push_back(read_sun(sun));
  }
  table.read("environment_strength", source.environment_strength, 0.0, largest_radiance);
  double rotation_deg = 0.0;
  table.read("environment_rotation_deg", rotation_deg, -360.0, 360.0);
  source.environment_rotation_rad = radians(rotation_deg);
}

/// Reads sizes that replace those of the file's own lights.
void read_light_sizes(TomlReader& table, SceneSource& source) {
  if (table.has("light_radius")) {
    double radius = 0.0;
    table.read("light_radius", radius, 0.0, largest_coordinate);
    source.light_radius_m = static_cast<float>(radius * source.metres_per_unit);
  }
  if (table.has("sun_radius_deg")) {
    double radius_deg = 0.0;
    table.read("sun_radius_deg", radius_deg, 0.0, 45.0);
    source.sun_angular_radius_rad = static_cast<float>(radians(radius_deg));
  }
}

void read_viewpoint(TomlReader& table, SceneSource& source) {
  read_camera(table.table(required("camera")), source);
  table.read("exposure_stops", source.exposure_stops, -max_exposure_stops, max_exposure_stops);
}

void read_lights_and_objects(TomlReader& table, SceneSource& source) {
  for (const TomlReader& light : table.tables("light")) {
    source.lights.push_back(read_light(light, source.metres_per_unit));
  }
  for (const TomlReader& object : table.tables("object")) {
    source.objects.push_back(read_object(object, source.metres_per_unit));
    require_choosable(object, source);
  }
}

void read_file_facts(TomlReader& table, Descriptor& descriptor) {
  table.read("file", descriptor.file_name);
  table.read("origin", descriptor.origin);
  table.read("sha256", descriptor.sha256);
  table.read("address", descriptor.address);
  std::int64_t size_bytes = 0;
  table.read("size_bytes", size_bytes, 1, std::numeric_limits<std::int64_t>::max());
  descriptor.size_bytes = static_cast<std::uint64_t>(size_bytes);
  const bool is_name_of_scene =
      is_plain_name(descriptor.file_name) && is_called_like_scene(descriptor.file_name);
  if (table.has("file") && !is_name_of_scene) {
    table.fail(table.source("file"),
               "file must be the name, without folders, of a .glb, .gltf or .obj file",
               "for example file = \"NAME.glb\"");
  }
  if (!descriptor.sha256.empty() && !is_digest(descriptor.sha256)) {
    table.fail(table.source("sha256"), "sha256 must be 64 lower-case hexadecimal digits",
               "use the output of sha256sum");
  }
  if (!descriptor.address.empty() && (descriptor.sha256.empty() || size_bytes == 0)) {
    table.fail(table.source("address"), "a file from the web needs sha256 and size_bytes",
               "so that it can be checked");
  }
}

void require_known_builtins(const TomlReader& table, const Descriptor& descriptor) {
  if (descriptor.is_builtin && !is_builtin_name(descriptor.name)) {
    table.fail(table.source("builtin"), "no built-in scene is named " + descriptor.name,
               "see 'foveola scene list'");
  }
  if (!descriptor.counterpart.empty() && !is_builtin_name(descriptor.counterpart)) {
    table.fail(table.source("counterpart"), "no built-in scene is named " + descriptor.counterpart,
               "see 'foveola scene list'");
  }
}

Descriptor descriptor_from(const fs::path& file, const toml::table& toml) {
  TomlReader table(file.string(), toml, "");
  Descriptor descriptor;
  descriptor.name = file.stem().string();
  descriptor.path = file;
  descriptor.source.name = descriptor.name;
  descriptor.source.title = table.require_text("title");
  table.read("author", descriptor.author);
  table.read("licence", descriptor.licence);
  table.read("builtin", descriptor.is_builtin);
  table.read("counterpart", descriptor.counterpart);
  read_file_facts(table, descriptor);
  descriptor.source.described_sha256 = descriptor.sha256;
  if (descriptor.is_builtin == !descriptor.file_name.empty()) {
    table.fail(table.source(), "the scene must be either built in or have a file",
               "use one of builtin = true and file = \"NAME.glb\"");
  }
  require_known_builtins(table, descriptor);
  table.read("metres_per_unit", descriptor.source.metres_per_unit, 1e-6, 1e6);
  read_light_units(table, descriptor.source);
  read_light_sizes(table, descriptor.source);
  read_light_from_outside(table, file.parent_path(), descriptor.source);
  read_viewpoint(table, descriptor.source);
  read_lights_and_objects(table, descriptor.source);
  table.reject_unknown_keys();
  descriptor.source.descriptor = file;
  return descriptor;
}

toml::table parse_descriptor_table(const fs::path& file, const std::string& text) {
  return parse_toml(file.string(), text, "see scenes/arcade/arcade.toml for an example");
}

}  // namespace

Descriptor read_descriptor(const fs::path& file) {
  return parse_descriptor(file, read_toml_file(file));
}

Descriptor parse_descriptor(const fs::path& file, const std::string& text) {
  return descriptor_from(file, parse_descriptor_table(file, text));
}

bool is_descriptor(const fs::path& file) {
  const toml::table table = parse_descriptor_table(file, read_toml_file(file));
  return table.contains("file") || table.contains("builtin") || table.contains("camera");
}

bool is_described_file(const Descriptor& descriptor, const fs::path& file) {
  std::error_code failure;
  const std::uintmax_t size_bytes = fs::file_size(file, failure);
  if (failure || !std::ifstream(file)) {
    throw Error(file.string(), "cannot be read", "check its permissions");
  }
  // Sizes first, as they cost nothing.
  return (descriptor.size_bytes == 0 || size_bytes == descriptor.size_bytes) &&
         (descriptor.sha256.empty() || sha256_of_file(file) == descriptor.sha256);
}

}  // namespace foveola::scenes
