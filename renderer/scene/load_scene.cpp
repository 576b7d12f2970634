#include "renderer/scene/load_scene.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/environment.h"
#include "renderer/scene/foreign_format.h"
#include "renderer/scene/prepare/far_geometry.h"
#include "renderer/scene/prepare/nested_volumes.h"

namespace foveola {
namespace {

bool is_radiance(const Rgb& value) {
  return is_finite(value) && value.r >= 0.0F && value.g >= 0.0F && value.b >= 0.0F;
}

void require_radiance(const Rgb& value, const std::string& where, const char* name) {
  if (!is_radiance(value)) {
    throw Error(where, fmt::format("the {} is ({}, {}, {})", name, value.r, value.g, value.b),
                "give three finite numbers of at least 0");
  }
}

/// 0, 1 or 2 if `direction` is plus or minus that axis, else -1.
int axis_of(const Vec3& direction) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 unit(0.0F);
    unit[axis] = 1.0F;
    if (direction == unit || direction == -unit) {
      return axis;
    }
  }
  return -1;
}

void require_valid(const RectangleLight& light, const std::string& where) {
  if (axis_of(light.normal) < 0) {
    throw Error(where, "the normal of the light is not an axis",
                "use one of (+-1, 0, 0), (0, +-1, 0), (0, 0, +-1)");
  }
  if (!is_finite(light.center)) {
    throw Error(where, "the centre of the light is not finite", "give three finite coordinates");
  }
  if (!(light.size.x > 0.0F && light.size.y > 0.0F) || !std::isfinite(light.size.x) ||
      !std::isfinite(light.size.y)) {
    throw Error(where, fmt::format("the size of the light is {} x {}", light.size.x, light.size.y),
                "give two positive, finite lengths in metres");
  }
  require_radiance(light.radiance, where, "radiance of the light");
}

void require_valid(const Sun& sun, const std::string& where) {
  require_radiance(sun.irradiance, where, "irradiance of the sun");
  if (!(sun.angular_radius_rad >= 0.0 && sun.angular_radius_rad < radians(90.0))) {
    throw Error(
        where,
        fmt::format("the angular radius of the sun is {} degrees", degrees(sun.angular_radius_rad)),
        "choose one of at least 0 and under 90 degrees");
  }
}

Material emitter(const std::string& name, const Rgb& radiance) {
  Material material;
  material.name = name;
  material.base_color = Rgb(0.0F);
  material.emission = radiance;
  return material;
}

/// center: relative to the scene's origin.
Mesh rectangle(const RectangleLight& light, const Vec3& center) {
  const int axis = axis_of(light.normal);
  const int first_axis = axis == 0 ? 1 : 0;
  const int second_axis = axis == 2 ? 1 : 2;
  Vec3 right(0.0F);
  Vec3 up(0.0F);
  right[first_axis] = 0.5F * light.size.x;
  up[second_axis] = 0.5F * light.size.y;
  if (glm::dot(glm::cross(right, up), light.normal) < 0.0F) {
    right = -right;
  }
  Mesh mesh;
  mesh.positions = {center - right - up, center + right - up, center + right + up,
                    center - right + up};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

void require_valid(const SceneSource& source) {
  for (std::size_t i = 0; i < source.lights.size(); ++i) {
    require_valid(source.lights[i], fmt::format("{}: lights[{}]", source.name, i));
  }
  for (std::size_t i = 0; i < source.suns.size(); ++i) {
    require_valid(source.suns[i], fmt::format("{}: suns[{}]", source.name, i));
  }
  if (source.environment_radiance) {
    require_radiance(*source.environment_radiance, source.name, "radiance of the environment");
  }
  if (!(std::isfinite(source.metres_per_unit) && source.metres_per_unit > 0.0)) {
    throw Error(source.name, "the metres of a unit are not positive");
  }
  const auto is_size = [](double value) { return std::isfinite(value) && value >= 0.0; };
  if (!is_size(static_cast<float>(source.environment_strength))) {
    throw Error(source.name, "the strength of the environment is negative or beyond any float",
                "give a factor up to 3e38");
  }
  if (!std::isfinite(source.environment_rotation_rad)) {
    throw Error(source.name, "the rotation of the environment is not finite");
  }
  if (!is_size(source.light_radius_m.value_or(0.0F)) ||
      !is_size(source.sun_angular_radius_rad.value_or(0.0F))) {
    throw Error(source.name, "the radius of the lights is negative or not finite");
  }
}

/// Distances grow, and intensities with their squares: the picture stays equal.
void scale_light(PunctualLight& light, float scale) {
  light.position *= scale;
  light.radius_m *= scale;
  if (light.kind != PunctualLight::Kind::directional) {
    light.intensity *= scale * scale;
  }
}

void scale_placement(Instance& instance, float scale) {
  for (int column = 0; column < 4; ++column) {
    Vec4& image = instance.world_from_local[column];
    image = Vec4(scale * Vec3(image), image.w);
  }
}

/// Prototypes are scaled where they are placed.
void scale_world(Scene& scene, double metres_per_unit) {
  const auto scale = static_cast<float>(metres_per_unit);
  scene.origin *= metres_per_unit;
  for (Mesh& mesh : scene.meshes) {
    for (Vec3& position : mesh.positions) {
      position *= scale;
    }
  }
  for (Instance& instance : scene.instances) {
    scale_placement(instance, scale);
  }
  for (Material& material : scene.materials) {
    material.attenuation_distance_m *= scale;
  }
  for (PunctualLight& light : scene.lights) {
    scale_light(light, scale);
  }
  for (CameraView& camera : scene.cameras) {
    camera.position *= scale;
  }
}

void add_light(Scene& scene, const RectangleLight& light, std::size_t number) {
  Mesh mesh = rectangle(light, Vec3(DVec3(light.center) - scene.origin));
  mesh.name = fmt::format("light {}", number);
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(emitter(mesh.name, light.radiance));
  scene.meshes.push_back(std::move(mesh));
}

void add_sun(Scene& scene, const Sun& sun) {
  PunctualLight light;
  light.name = "sun";
  light.kind = PunctualLight::Kind::directional;
  light.direction = -direction_from(sun.place);
  light.intensity = sun.irradiance;
  light.angular_radius_rad = static_cast<float>(sun.angular_radius_rad);
  scene.lights.push_back(std::move(light));
}

/// `radiance` times the environment's strength. Throws Error if it overflows a float.
Rgb strengthened(const Rgb& radiance, const SceneSource& source) {
  const Rgb result = radiance * static_cast<float>(source.environment_strength);
  if (!is_radiance(result)) {
    throw Error(source.name, "the environment times its strength is beyond any float",
                "give a smaller strength");
  }
  return result;
}

/// The environment's rotation also rotates the sun, which is not in its map.
void add_sun_of_sky(Scene& scene, SunAndSky sky, const SceneSource& source) {
  sky.sun.azimuth_rad += source.environment_rotation_rad;
  if (std::optional<PunctualLight> sun = sun_light(sky)) {
    sun->intensity = strengthened(sun->intensity, source);
    scene.lights.push_back(*sun);
  }
}

void replace_environment(Scene& scene, const SceneSource& source, Warnings& warnings) {
  if (source.environment_radiance) {
    scene.environment.emplace().radiance = *source.environment_radiance;
  }
  if (source.environment_file) {
    scene.environment = load_environment(*source.environment_file, warnings);
    scene.files.insert(*source.environment_file);
  }
  if (source.sky) {
    scene.environment = sky_environment(*source.sky);
    add_sun_of_sky(scene, *source.sky, source);
  }
  if (scene.environment) {
    scene.environment->radiance = strengthened(scene.environment->radiance, source);
    scene.environment->rotation_rad += source.environment_rotation_rad;
  }
}

void resize_lights(Scene& scene, const SceneSource& source) {
  for (PunctualLight& light : scene.lights) {
    if (light.kind == PunctualLight::Kind::directional) {
      light.angular_radius_rad = source.sun_angular_radius_rad.value_or(light.angular_radius_rad);
    } else {
      light.radius_m = source.light_radius_m.value_or(light.radius_m);
    }
  }
}

/// nullopt if the file is the one that the source was written for.
std::optional<std::string> warning_of_another_file(const Scene& scene, const SceneSource& source) {
  if (source.described_sha256.empty() || scene.sha256 == source.described_sha256) {
    return std::nullopt;
  }
  return fmt::format(
      "{} is not the file that the descriptor of \"{}\" means: its SHA-256 differs, and camera, "
      "lights and objects may not fit; say so wherever it is shown",
      source.file.filename().string(), source.title);
}

/// Tells the user of a descriptor that was used without being named.
std::optional<std::string> note_of_descriptor(const SceneSource& source) {
  if (source.descriptor_beside.empty()) {
    return std::nullopt;
  }
  return fmt::format("{} is shown with the settings of {} beside it",
                     source.file.filename().string(), source.descriptor_beside.filename().string());
}

}  // namespace

Scene load_scene_file(const std::filesystem::path& path, const SceneReading& reading) {
  require_readable_format(path);
  const bool is_obj = lower_case_extension(path) == ".obj";
  Scene scene = is_obj ? load_obj(path, reading) : load_gltf(path, reading);
  if (is_obj && reading.time_s) {
    scene.warnings.emplace_back(
        "the time and clip of animations are ignored: an OBJ file has none");
  }
  if (const std::optional<std::string> warning = warning_of_nested_volumes(scene)) {
    scene.warnings.push_back(*warning);
  }
  return scene;
}

Scene load_scene(const SceneSource& source, KeptSceneParts* kept) {
  require_valid(source);
  Scene scene = load_scene_file(source.file, {.light_units = source.light_units,
                                              .strict = source.strict,
                                              .time_s = source.time_s,
                                              .clip = source.clip,
                                              .kept = kept});
  for (const auto& line : {warning_of_another_file(scene, source), note_of_descriptor(source)}) {
    if (line) {
      scene.warnings.insert(scene.warnings.begin(), *line);
    }
  }
  if (source.metres_per_unit != 1.0) {
    scale_world(scene, source.metres_per_unit);
  }
  for (std::size_t i = 0; i < source.lights.size(); ++i) {
    add_light(scene, source.lights[i], i + 1);
  }
  for (const Sun& sun : source.suns) {
    add_sun(scene, sun);
  }
  Warnings warnings;
  drop_far_parts(scene, warnings);
  replace_environment(scene, source, warnings);
  const std::vector<std::string> lines = warnings.lines();
  scene.warnings.insert(scene.warnings.end(), lines.begin(), lines.end());
  resize_lights(scene, source);
  return scene;
}

}  // namespace foveola
