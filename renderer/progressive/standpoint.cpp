#include "renderer/progressive/standpoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "renderer/progressive/picture.h"
#include "renderer/progressive/surroundings.h"
#include "renderer/scene/scene_facts.h"

namespace foveola {
namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

void include(const Bounds& more, Bounds& bounds) {
  bounds.lower = glm::min(bounds.lower, more.lower);
  bounds.upper = glm::max(bounds.upper, more.upper);
}

std::vector<Bounds> bounds_of_objects(const Scene& scene) {
  std::vector<Bounds> all;
  all.reserve(scene.object_count());
  for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
    all.push_back(scene.bounds_of(object));
  }
  return all;
}

/// Extents of the bounds along the axes, relative to the largest.
struct Shape {
  Vec3 extents;
  int thinnest_axis;

  explicit Shape(const Bounds& bounds)
      : extents((bounds.upper - bounds.lower) / max_component(bounds.upper - bounds.lower)),
        thinnest_axis(static_cast<int>(std::min_element(&extents.x, &extents.x + 3) - &extents.x)) {
  }

  bool is_flat() const { return extents[thinnest_axis] < 1e-3F; }

  /// The direction from the centre from which no slab or sheet is seen edge-on.
  Vec3 front() const {
    Vec3 direction(0.0F, 0.0F, 1.0F);
    direction[thinnest_axis] = 1.0F;
    return glm::normalize(direction);
  }
};

/// The bounds that the picture must contain.
struct Subject {
  std::vector<std::uint32_t> objects;
  Bounds bounds{.lower = Vec3(nowhere), .upper = Vec3(-nowhere)};
  bool leaves_out_floor = false;
};

/// Whether it is a floor under all the rest, and extends beyond it on all sides.
bool is_floor_under(const Bounds& floor, const Bounds& rest) {
  const Vec3 extent = floor.upper - floor.lower;
  constexpr float flat = 0.01F;
  const float room_for_feet = 0.1F * (rest.upper.y - rest.lower.y);
  return extent.y <= flat * std::min(extent.x, extent.z) &&
         floor.upper.y <= rest.lower.y + room_for_feet && floor.lower.x < rest.lower.x &&
         floor.lower.z < rest.lower.z && floor.upper.x > rest.upper.x &&
         floor.upper.z > rest.upper.z;
}

/// Everything, or all but the largest object if that is a floor.
Subject subject_of(const std::vector<Bounds>& objects) {
  const auto area = [](const Bounds& bounds) {
    const Vec3 extent = bounds.upper - bounds.lower;
    return extent.x * extent.z;
  };
  const auto largest = std::ranges::max_element(
      objects, [&](const Bounds& a, const Bounds& b) { return area(a) < area(b); });
  Subject all;
  Subject rest{.objects = {}, .bounds = all.bounds, .leaves_out_floor = true};
  for (std::uint32_t object = 0; object < objects.size(); ++object) {
    if (objects[object].lower.x > objects[object].upper.x) {
      continue;
    }
    all.objects.push_back(object);
    include(objects[object], all.bounds);
    if (object != static_cast<std::uint32_t>(largest - objects.begin())) {
      rest.objects.push_back(object);
      include(objects[object], rest.bounds);
    }
  }
  const bool has_rest = !rest.objects.empty() && rest.bounds.lower != rest.bounds.upper;
  return has_rest && is_floor_under(*largest, rest.bounds) ? rest : all;
}

/// Score of a picture from outside: the mean over its rays' hits. A front face counts 1 plus its
/// depth behind the nearest point of the bounds, relative to the bounds' size. A back face counts
/// twice its depth: nearby it is the wrong side of something, but deep within it is the inside of
/// an open object, like a helmet seen from the front.
double shown_from(const Scene& scene, const RayScene& rays, const Subject& subject,
                  const AzimuthElevation& heading, const FieldOfView& field_of_view) {
  Framing framing(heading, field_of_view);
  framing.include(subject.bounds);
  const Vec3 from = framing.position();
  const Vec3 nearest = glm::clamp(from, subject.bounds.lower, subject.bounds.upper);
  const double before_m = glm::distance(DVec3(from), DVec3(nearest));
  const double size_m = glm::distance(DVec3(subject.bounds.lower), DVec3(subject.bounds.upper));
  double shown = 0.0;
  int hits = 0;
  for (const SightLine& line : sight_lines(rays, from, Viewport(heading, field_of_view), {16, 9})) {
    if (!line.hit.missed()) {
      ++hits;
      const double depth = std::clamp((line.hit.t - before_m) / size_m, 0.0, 1.0);
      shown += is_front(scene, line.hit, line.direction) ? 1.0 + depth : 2.0 * depth;
    }
  }
  return hits > 0 ? shown / hits : 0.0;
}

/// From the front and right and slightly from above, unless another side scores much higher.
AzimuthElevation best_heading(const Scene& scene, const RayScene& rays, const Subject& subject,
                              const FieldOfView& field_of_view) {
  constexpr double much_more = 0.3;
  AzimuthElevation best;
  double most = -1.0;
  for (const double below_deg : {20.0, 40.0}) {
    for (const double azimuth_deg : {-30.0, 30.0, -150.0, 150.0}) {
      const AzimuthElevation heading{.azimuth_rad = radians(azimuth_deg),
                                     .elevation_rad = radians(-below_deg)};
      const double shown = shown_from(scene, rays, subject, heading, field_of_view);
      if (most < 0.0 || shown > most + much_more) {
        best = heading;
        most = shown;
      }
    }
  }
  return best;
}

Standpoint outside(const Scene& scene, const Subject& subject, const AzimuthElevation& heading,
                   const FieldOfView& field_of_view, std::string reason) {
  Framing framing(heading, field_of_view);
  for (const std::uint32_t object : subject.objects) {
    framing.include(scene, object);
  }
  return {.position = framing.position(), .heading = heading, .reason = std::move(reason)};
}

bool has_extent(const Bounds& bounds) {
  constexpr float largest = 1e18F;  // Embree finds no hits beyond it
  return bounds.lower.x <= bounds.upper.x && bounds.lower != bounds.upper &&
         max_component(bounds.upper - bounds.lower) < largest;
}

/// The options --camera and --head, in the file's world.
std::string as_options(const Scene& scene, const Vec3& position, const AzimuthElevation& heading) {
  const DVec3 place = DVec3(position) + scene.origin;
  const auto whole_deg = [](double angle_rad) { return std::round(degrees(angle_rad)) + 0.0; };
  return fmt::format("--camera {:.4g},{:.4g},{:.4g} --head {:g},{:g}", place.x, place.y, place.z,
                     whole_deg(heading.azimuth_rad), whole_deg(heading.elevation_rad));
}

/// Share of a picture's rays that hit something.
double share_covered(const RayScene& rays, const Vec3& from, const Viewport& viewport) {
  const std::vector<SightLine> lines = sight_lines(rays, from, viewport, {64, 36});
  const auto hits =
      std::ranges::count_if(lines, [](const SightLine& line) { return !line.hit.missed(); });
  return static_cast<double>(hits) / static_cast<double>(lines.size());
}

/// A camera in front of the surroundings of the first vertex, of a hundredth of the scene's size.
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

Standpoint choose_standpoint(const Scene& scene, const RayScene& rays,
                             const FieldOfView& field_of_view) {
  const std::vector<Bounds> objects = bounds_of_objects(scene);
  Bounds bounds{.lower = Vec3(nowhere), .upper = Vec3(-nowhere)};
  for (const Bounds& object : objects) {
    include(object, bounds);
  }
  if (!has_extent(bounds)) {
    const bool is_somewhere = bounds.lower.x <= bounds.upper.x;
    const Vec3 middle = is_somewhere ? 0.5F * bounds.lower + 0.5F * bounds.upper : Vec3(0.0F);
    return {.position = middle, .heading = {}, .reason = "from the middle of its bounds"};
  }
  const Subject subject = subject_of(objects);
  const Shape shape(bounds);
  if (shape.is_flat()) {
    return outside(scene, subject, azimuth_elevation(-shape.front()), field_of_view,
                   "from its front, since it is flat");
  }
  if (std::optional<Standpoint> room = standpoint_in_room(scene, rays, bounds, field_of_view)) {
    return *std::move(room);
  }
  return outside(scene, subject, best_heading(scene, rays, subject, field_of_view), field_of_view,
                 subject.leaves_out_floor
                     ? "from outside with everything on the floor in the picture"
                     : "from outside with all of it in the picture");
}

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
        "the scene has no visible objects, only an environment; export all its objects as meshes, "
        "not only selected ones");
  }
  if (has_light(scene) && !has_studio_light) {
    return lacks;
  }
  if (camera_is_enclosed) {
    lacks.emplace_back(
        "nothing in the scene emits light, so that pictures of it are black; it is closed around "
        "the camera, where no light comes in from outside: export lights in it, or a material that "
        "emits, or see it from outside by --camera X,Y,Z and --environment 1,1,1");
  } else if (has_studio_light) {
    lacks.emplace_back(
        "nothing in the scene emits light: it is shown in a studio light; choose another by "
        "--environment, see --help for daylight and images");
  } else {
    lacks.emplace_back(
        "nothing in the scene emits light, so that pictures of it are black; --environment 1,1,1 "
        "of render and preview lights it evenly, and see their --help for daylight and images");
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
    notes.push_back(
        fmt::format("nearly all of the picture is empty, as the scene's parts are small and far "
                    "apart; {} is in front of one of them",
                    as_options(scene, place_near_a_part(scene, standpoint, field_of_view),
                               standpoint.heading)));
  }
  return notes;
}

}  // namespace foveola
