#include "renderer/progressive/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "renderer/trace/surfaces/triangle.h"

namespace foveola {
namespace {

constexpr double eye_height_m = 1.6;
/// Heights of rooms for people.
constexpr double lowest_room_m = 1.9;
constexpr double highest_room_m = 100.0;

/// Minimum share of rays with hits in a room, which may lack its ceiling.
constexpr double least_enclosure = 0.6;
constexpr double nearly_all = 0.95;

/// A place where a person could stand.
struct Place {
  Vec3 eye{0.0F};
  double room_height_m = 0.0;
  bool is_at_eye_height = false;
};

float distance_along(const RayScene& rays, const Vec3& from, const Vec3& direction) {
  return rays.closest_hit(from, direction).t;
}

/// The place above the floor below `point`; nullopt without a floor.
std::optional<Place> place_at(const RayScene& rays, const Vec3& point, float top) {
  const float down_m = distance_along(rays, point, {0.0F, -1.0F, 0.0F});
  if (!std::isfinite(down_m)) {
    return std::nullopt;
  }
  const float up_m =
      std::min(distance_along(rays, point, {0.0F, 1.0F, 0.0F}), std::max(top - point.y, 0.0F));
  Place place{.eye = point, .room_height_m = static_cast<double>(down_m) + up_m};
  place.is_at_eye_height =
      place.room_height_m >= lowest_room_m && place.room_height_m <= highest_room_m;
  const double height_m = place.is_at_eye_height ? eye_height_m : 0.5 * place.room_height_m;
  place.eye.y = static_cast<float>(point.y - down_m + height_m);
  return place;
}

/// Places all over the bounds, above every floor found.
std::vector<Place> places_in(const RayScene& rays, const Bounds& bounds) {
  constexpr std::array along = {0.1F, 0.3F, 0.5F, 0.7F, 0.9F};
  constexpr std::array upwards = {0.25F, 0.5F, 0.75F};
  std::vector<Place> places;
  for (const float y : upwards) {
    for (const float z : along) {
      for (const float x : along) {
        const Vec3 point = glm::mix(bounds.lower, bounds.upper, Vec3(x, y, z));
        if (const std::optional<Place> place = place_at(rays, point, bounds.upper.y)) {
          places.push_back(*place);
        }
      }
    }
  }
  return places;
}

/// The enclosed places of a scene.
struct Enclosure {
  Place widest;
  double mean_share_fronts = 0.0;  ///< over the places; see Surroundings
};

/// The widest place has the most free space, preferably among places with mostly front faces.
/// nullopt if no place is enclosed.
std::optional<Enclosure> enclosure_of(const Scene& scene, const RayScene& rays,
                                      const std::vector<Place>& places, double furthest_m) {
  constexpr int directions = 64;
  std::optional<Place> widest;
  bool sees_fronts = false;
  double space_m = 0.0;
  double sum_of_fronts = 0.0;
  int enclosed = 0;
  for (const Place& place : places) {
    const Surroundings around = look_around(scene, rays, place.eye, directions, furthest_m);
    if (around.share_hit < least_enclosure) {
      continue;
    }
    ++enclosed;
    sum_of_fronts += around.share_fronts;
    const bool fronts = around.share_fronts >= 0.5;
    if ((fronts && !sees_fronts) || (fronts == sees_fronts && around.space_m > space_m)) {
      widest = place;
      sees_fronts = fronts;
      space_m = around.space_m;
    }
  }
  if (!widest) {
    return std::nullopt;
  }
  return Enclosure{.widest = *widest, .mean_share_fronts = sum_of_fronts / enclosed};
}

constexpr int level_directions = 48;

double level_azimuth_rad(int i) { return 2.0 * std::numbers::pi * i / level_directions; }

/// Horizontal distances at eye level, infinite without hits.
std::array<double, level_directions> level_distances_m(const RayScene& rays, const Vec3& eye) {
  std::array<double, level_directions> distances_m{};
  for (int i = 0; i < level_directions; ++i) {
    distances_m[static_cast<std::size_t>(i)] = distance_along(
        rays, eye, direction_from({.azimuth_rad = level_azimuth_rad(i), .elevation_rad = 0.0}));
  }
  return distances_m;
}

/// Whether there are hits on nearly all sides: two walls and a floor are not a room.
bool has_walls_around(const RayScene& rays, const Vec3& eye) {
  constexpr double least_walls = 0.75;
  const auto distances_m = level_distances_m(rays, eye);
  const auto walls = std::ranges::count_if(
      distances_m, [](double distance_m) { return std::isfinite(distance_m); });
  return static_cast<double>(walls) >= least_walls * level_directions;
}

bool is_room(const Scene& scene, const RayScene& rays, const Enclosure& enclosure,
             double furthest_m) {
  const Place& place = enclosure.widest;
  constexpr int directions = 256;
  const Surroundings around = look_around(scene, rays, place.eye, directions, furthest_m);
  if (around.share_hit < least_enclosure || !has_walls_around(rays, place.eye)) {
    return false;
  }
  if (is_light_in_sight(scene, rays, place.eye)) {
    return true;
  }
  if (around.share_fronts >= 0.5 &&
      share_of_fronts_from_outside(scene, rays, place.eye, furthest_m) < 0.5) {
    return true;
  }
  constexpr double furnished = 0.1;
  return place.is_at_eye_height && around.share_hit >= nearly_all &&
         enclosure.mean_share_fronts >= furnished;
}

/// The hits towards one azimuth: the distance at eye level, and the objects there and below.
struct Outlook {
  double log_depth = 0.0;
  std::set<std::uint32_t> objects;
};

std::vector<Outlook> outlooks(const RayScene& rays, const Vec3& eye, double furthest_m) {
  const auto distances_m = level_distances_m(rays, eye);
  std::vector<Outlook> all(distances_m.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].log_depth = std::log(std::clamp(distances_m[i], 1e-6 * furthest_m, furthest_m));
    for (const double below_deg : {0.0, 7.0, 14.0, 21.0}) {
      const Hit hit = rays.closest_hit(
          eye, direction_from({.azimuth_rad = level_azimuth_rad(static_cast<int>(i)),
                               .elevation_rad = radians(-below_deg)}));
      if (!hit.missed()) {
        all[i].objects.insert(hit.object);
      }
    }
  }
  return all;
}

/// Merges the 60 degrees around each azimuth.
std::vector<Outlook> wide_outlooks(const std::vector<Outlook>& narrow) {
  constexpr std::size_t to_either_side = 4;
  std::vector<Outlook> wide(narrow.size());
  for (std::size_t i = 0; i < narrow.size(); ++i) {
    for (std::size_t beside = 0; beside <= 2 * to_either_side; ++beside) {
      const Outlook& outlook =
          narrow[(i + narrow.size() + beside - to_either_side) % narrow.size()];
      wide[i].log_depth += outlook.log_depth / (2 * to_either_side + 1);
      wide[i].objects.insert(outlook.objects.begin(), outlook.objects.end());
    }
  }
  return wide;
}

/// The azimuth with the most depth (geometric mean of distances) and objects around it, equally
/// weighted, each relative to its maximum over azimuths.
double best_azimuth_rad(const RayScene& rays, const Vec3& eye, double furthest_m) {
  const std::vector<Outlook> all = wide_outlooks(outlooks(rays, eye, furthest_m));
  double deepest = all.front().log_depth;
  std::size_t max_objects = 1;
  for (const Outlook& outlook : all) {
    deepest = std::max(deepest, outlook.log_depth);
    max_objects = std::max(max_objects, outlook.objects.size());
  }
  std::size_t best = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double seen =
        std::exp(all[i].log_depth - deepest) +
        static_cast<double>(all[i].objects.size()) / static_cast<double>(max_objects);
    constexpr double rounding = 1e-6;
    if (seen > most + rounding) {
      most = seen;
      best = i;
    }
  }
  return wrapped_angle(level_azimuth_rad(static_cast<int>(best)));
}

/// Amount of content in a picture: the length of its outlines, where one of two adjacent rays is
/// much longer.
int outlines_in(const RayScene& rays, const Vec3& eye, const Viewport& viewport) {
  constexpr IVec2 grid{48, 27};
  constexpr float much_further = 1.2F;
  const std::vector<SightLine> lines = sight_lines(rays, eye, viewport, grid);
  const auto is_outline = [&](std::size_t one, std::size_t other) {
    const auto [nearer, further] = std::minmax(lines[one].hit.t, lines[other].hit.t);
    return further > much_further * nearer;
  };
  int outlines = 0;
  for (int y = 0; y < grid.y; ++y) {
    for (int x = 0; x < grid.x; ++x) {
      const auto at = static_cast<std::size_t>(y * grid.x + x);
      outlines += x + 1 < grid.x && is_outline(at, at + 1) ? 1 : 0;
      outlines += y + 1 < grid.y && is_outline(at, at + grid.x) ? 1 : 0;
    }
  }
  return outlines;
}

/// Straight ahead, or downwards for much more content.
double best_elevation_rad(const RayScene& rays, const Vec3& eye, double azimuth_rad,
                          const FieldOfView& field_of_view) {
  constexpr double much_more = 1.2;
  double best_rad = 0.0;
  double most = 0.0;
  for (const double below_deg : {0.0, 10.0, 20.0}) {
    const AzimuthElevation heading{.azimuth_rad = azimuth_rad,
                                   .elevation_rad = -radians(below_deg) + 0.0};
    const int outlines = outlines_in(rays, eye, Viewport(heading, field_of_view));
    if (outlines > much_more * most) {
      best_rad = heading.elevation_rad;
      most = outlines;
    }
  }
  return best_rad;
}

}  // namespace

Vec3 fibonacci_direction(int index, int count) {
  const double y = 1.0 - (2.0 * index + 1.0) / count;
  const double azimuth_rad = 2.0 * std::numbers::pi * index / std::numbers::phi;
  const double radius = std::sqrt(1.0 - y * y);
  return {radius * std::cos(azimuth_rad), y, radius * std::sin(azimuth_rad)};
}

bool is_front(const Scene& scene, const Hit& hit, const Vec3& direction) {
  return glm::dot(Triangle(scene, hit.object, hit.triangle).front_normal(), direction) < 0.0F;
}

Surroundings look_around(const Scene& scene, const RayScene& rays, const Vec3& from, int rays_count,
                         double furthest_m) {
  int hits = 0;
  int fronts = 0;
  double log_distances = 0.0;
  for (int i = 0; i < rays_count; ++i) {
    const Vec3 direction = fibonacci_direction(i, rays_count);
    const Hit hit = rays.closest_hit(from, direction);
    if (!hit.missed()) {
      ++hits;
      fronts += is_front(scene, hit, direction) ? 1 : 0;
    }
    const double nearest_m = 1e-6 * furthest_m;  // lower limit of logarithms
    log_distances += std::log(std::clamp<double>(hit.t, nearest_m, furthest_m));
  }
  return {.share_hit = static_cast<double>(hits) / rays_count,
          .share_fronts = hits > 0 ? static_cast<double>(fronts) / hits : 0.0,
          .space_m = std::exp(log_distances / rays_count)};
}

double share_of_fronts_from_outside(const Scene& scene, const RayScene& rays, const Vec3& target,
                                    double distance_m) {
  constexpr int directions = 64;
  int hits = 0;
  int fronts = 0;
  for (int i = 0; i < directions; ++i) {
    const Vec3 outwards = fibonacci_direction(i, directions);
    const Ray ray{.origin = target + static_cast<float>(distance_m) * outwards,
                  .direction = -outwards,
                  .t_max = static_cast<float>(distance_m)};
    const Hit hit = rays.closest_hit(ray);
    if (!hit.missed()) {
      ++hits;
      fronts += is_front(scene, hit, ray.direction) ? 1 : 0;
    }
  }
  return hits > 0 ? static_cast<double>(fronts) / hits : 1.0;
}

std::vector<SightLine> sight_lines(const RayScene& rays, const Vec3& from, const Viewport& viewport,
                                   const IVec2& cells) {
  std::vector<SightLine> lines;
  lines.reserve(static_cast<std::size_t>(cells.x) * cells.y);
  for (int y = 0; y < cells.y; ++y) {
    for (int x = 0; x < cells.x; ++x) {
      const Vec3 direction = viewport.direction((Vec2(x, y) + 0.5F) / Vec2(cells));
      lines.push_back({.direction = direction, .hit = rays.closest_hit(from, direction)});
    }
  }
  return lines;
}

bool is_enclosed(const RayScene& rays, const Vec3& from) {
  constexpr int directions = 256;
  int i = 0;
  while (i < directions && !rays.closest_hit(from, fibonacci_direction(i, directions)).missed()) {
    ++i;
  }
  return i == directions;
}

bool is_light_in_sight(const Scene& scene, const RayScene& rays, const Vec3& from) {
  return std::ranges::any_of(scene.lights, [&](const PunctualLight& light) {
    return light.kind != PunctualLight::Kind::directional &&
           rays.closest_hit(Ray{.origin = from, .direction = light.position - from, .t_max = 1.0F})
               .missed();
  });
}

std::optional<Standpoint> standpoint_in_room(const Scene& scene, const RayScene& rays,
                                             const Bounds& bounds,
                                             const FieldOfView& field_of_view) {
  const double furthest_m = glm::distance(DVec3(bounds.lower), DVec3(bounds.upper));
  const std::optional<Enclosure> enclosure =
      enclosure_of(scene, rays, places_in(rays, bounds), furthest_m);
  if (!enclosure || !is_room(scene, rays, *enclosure, furthest_m)) {
    return std::nullopt;
  }
  const Place& place = enclosure->widest;
  const double azimuth_rad = best_azimuth_rad(rays, place.eye, furthest_m);
  const double elevation_rad = best_elevation_rad(rays, place.eye, azimuth_rad, field_of_view);
  return Standpoint{.position = place.eye,
                    .heading = {.azimuth_rad = azimuth_rad, .elevation_rad = elevation_rad},
                    .reason = place.is_at_eye_height
                                  ? "from 1.6 m above the floor of a room where it is widest, "
                                    "looking where there is most to see"
                                  : "from half the height of a room where it is widest, looking "
                                    "where there is most to see"};
}

}  // namespace foveola
