#include "renderer/progressive/first_look.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "renderer/progressive/framing.h"
#include "renderer/progressive/surroundings.h"
#include "renderer/scene/scene_facts.h"

namespace foveola {
namespace {

/// As --camera and --head take them, in the file's world.
std::string as_options(const Scene& scene, const Vec3& position, const AzimuthElevation& heading) {
  const DVec3 place = DVec3(position) + scene.origin;
  const auto whole_deg = [](double angle_rad) { return std::round(degrees(angle_rad)) + 0.0; };
  return fmt::format("--camera {:.4g},{:.4g},{:.4g} --head {:g},{:g}", place.x, place.y, place.z,
                     whole_deg(heading.azimuth_rad), whole_deg(heading.elevation_rad));
}

/// The share of a picture's rays that meet something.
double share_covered(const RayScene& rays, const Vec3& from, const Viewport& viewport) {
  const std::vector<SightLine> lines = sight_lines(rays, from, viewport, {64, 36});
  const auto hits = std::count_if(lines.begin(), lines.end(),
                                  [](const SightLine& line) { return !line.hit.missed(); });
  return static_cast<double>(hits) / static_cast<double>(lines.size());
}

/// A camera before what lies around the first vertex, in a hundredth of the scene's size.
Vec3 place_near_a_part(const Scene& scene, const Standpoint& standpoint,
                       const FieldOfView& field_of_view) {
  constexpr float nearby = 0.01F;
  const Bounds all = scene.bounds();
  const float radius = nearby * glm::distance(all.lower, all.upper);
  Framing framing(standpoint.heading, field_of_view);
  std::optional<Vec3> first;
  for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
    for (const Vec3& position : scene.mesh_of(object).positions) {
      const Vec3 vertex = scene.in_world(object, position);
      first = first.value_or(vertex);
      if (glm::distance(vertex, *first) <= radius) {
        framing.include(vertex);
      }
    }
  }
  return framing.position();
}

}  // namespace

void add_studio_light(Scene& scene) {
  Environment& studio = scene.environment.emplace();
  studio.map_width = 8;
  studio.map_height = 4;
  for (const float radiance : {1.6F, 1.2F, 0.6F, 0.3F}) {
    studio.map.insert(studio.map.end(), 8, Rgb(radiance));
  }
}

std::vector<std::string> lacks_of(const Scene& scene, bool camera_is_enclosed,
                                  bool has_studio_light) {
  std::vector<std::string> lacks;
  if (scene.object_count() == 0) {
    lacks.emplace_back(
        "there is nothing to see but what surrounds the scene; export its objects as meshes, and "
        "not only those that are selected");
  }
  if (has_light(scene) && !has_studio_light) {
    return lacks;
  }
  if (camera_is_enclosed) {
    lacks.emplace_back(
        "nothing in the scene shines, so that pictures of it are black; it is closed around the "
        "camera, where no light comes in from outside: export lights in it, or a material that "
        "emits, or see it from outside by --camera X,Y,Z and --environment 1,1,1");
  } else if (has_studio_light) {
    lacks.emplace_back(
        "nothing in the scene shines: it is shown in a studio light; choose another by "
        "--environment, see --help for daylight and images");
  } else {
    lacks.emplace_back(
        "nothing in the scene shines, so that pictures of it are black; --environment 1,1,1 of "
        "render and preview lights it evenly, and see their --help for daylight and images");
  }
  return lacks;
}

std::vector<std::string> notes_on_standpoint(const Scene& scene, const RayScene& rays,
                                             const Standpoint& standpoint,
                                             const FieldOfView& field_of_view) {
  std::vector<std::string> notes;
  if (scene.object_count() == 0) {
    return notes;
  }
  notes.push_back(
      fmt::format("the file has no camera: it is seen {}; that is {}, where other places and "
                  "angles can be given",
                  standpoint.reason, as_options(scene, standpoint.position, standpoint.heading)));
  constexpr double least_covered = 0.002;
  const Viewport viewport(standpoint.heading, field_of_view);
  if (share_covered(rays, standpoint.position, viewport) < least_covered) {
    notes.push_back(fmt::format(
        "nearly all of the picture is empty, as the scene's parts are small and far apart; {} is "
        "before one of them",
        as_options(scene, place_near_a_part(scene, standpoint, field_of_view),
                   standpoint.heading)));
  }
  return notes;
}

}  // namespace foveola
