#include "renderer/progressive/proposed_objects.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "renderer/base/angles.h"
#include "renderer/base/transformed.h"
#include "renderer/progressive/surroundings.h"
#include "renderer/scene/prepare/made_up_names.h"

namespace foveola {
namespace {

constexpr std::size_t rays = std::size_t{1} << 18;
constexpr double solid_angle_of_ray = 4.0 * std::numbers::pi / static_cast<double>(rays);

Vec3 direction_of_ray(std::size_t ray) {
  return fibonacci_direction(static_cast<int>(ray), static_cast<int>(rays));
}

/// The meshes and instances of one name.
struct Group {
  std::string name;
  bool shines = true;
};

/// Each of the scene's objects belongs to one group.
struct Groups {
  std::vector<Group> list;
  std::vector<std::uint32_t> of_object;
};

Groups groups_of(const Scene& scene) {
  std::set<std::string> taken;
  for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
    taken.insert(scene.object_name(object));
  }
  Groups groups;
  std::map<std::string, std::uint32_t> known;
  for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
    std::string name = scene.object_name(object);
    if (name.empty()) {
      name = made_up_name("object", object + 1, taken);
    }
    const auto [entry, is_new] =
        known.emplace(name, static_cast<std::uint32_t>(groups.list.size()));
    if (is_new) {
      groups.list.push_back({.name = name});
    }
    const auto material = static_cast<std::size_t>(scene.mesh_of(object).material);
    groups.list[entry->second].shines &= scene.materials[material].is_emissive();
    groups.of_object.push_back(entry->second);
  }
  return groups;
}

/// The groups along one ray, each once, in order of distance.
struct RayThrough {
  std::vector<std::uint32_t> groups;
  float first_distance_m = 0.0F;
};

RayThrough follow(const RayScene& scene, const Groups& groups, const Vec3& origin,
                  const Vec3& direction) {
  constexpr int max_surfaces = 64;
  constexpr float beyond = 1.0F + 1e-4F;  // above the rounding of a hit's distance
  RayThrough through;
  Ray ray{.origin = origin, .direction = direction};
  for (int surface = 0; surface < max_surfaces; ++surface) {
    const Hit hit = scene.closest_hit(ray);
    if (hit.missed()) {
      break;
    }
    if (through.groups.empty()) {
      through.first_distance_m = hit.t;
    }
    const std::uint32_t group = groups.of_object[hit.object];
    if (std::ranges::find(through.groups, group) == through.groups.end()) {
      through.groups.push_back(group);
    }
    ray.t_min = hit.t * beyond;
  }
  return through;
}

/// The visible part of a group.
struct Seen {
  std::size_t meeting = 0;             ///< rays that would hit it if it were alone
  DVec3 sum{0.0};                      ///< of the directions of first hits
  std::vector<std::size_t> first_met;  ///< rays that hit it first
};

struct View {
  std::vector<RayThrough> through;  ///< per ray
  std::vector<Seen> seen;           ///< per group
};

View look_around(const LoadedScene& loaded, const Groups& groups, const Workers& workers) {
  constexpr std::size_t block = 1024;
  View view;
  view.through.resize(rays);
  workers.for_each_block(rays, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t ray = begin; ray < end; ++ray) {
      view.through[ray] =
          follow(loaded.tracer.ray_scene(), groups, loaded.camera.position, direction_of_ray(ray));
    }
  });
  view.seen.resize(groups.list.size());
  for (std::size_t ray = 0; ray < rays; ++ray) {
    const std::vector<std::uint32_t>& met = view.through[ray].groups;
    for (const std::uint32_t group : met) {
      ++view.seen[group].meeting;
    }
    if (!met.empty()) {
      view.seen[met.front()].first_met.push_back(ray);
      view.seen[met.front()].sum += DVec3(direction_of_ray(ray));
    }
  }
  return view;
}

/// The ray nearest to the centre of an object's visible part.
std::size_t middle_ray(const Seen& seen) {
  const Vec3 middle(glm::normalize(seen.sum));
  return *std::ranges::max_element(seen.first_met, [&](std::size_t a, std::size_t b) {
    return glm::dot(direction_of_ray(a), middle) < glm::dot(direction_of_ray(b), middle);
  });
}

/// The angle around `middle` that contains 98 of 100 rays to the object: a few may pass a table's
/// leg.
double angular_radius_rad(const Seen& seen, const Vec3& middle) {
  constexpr double covered = 0.98;
  std::vector<double> angles_rad = transformed(seen.first_met, [&](const std::size_t ray) {
    return angle_between(direction_of_ray(ray), middle);
  });
  const auto place = angles_rad.begin() + static_cast<std::ptrdiff_t>(
                                              covered * static_cast<double>(angles_rad.size() - 1));
  std::nth_element(angles_rad.begin(), place, angles_rad.end());
  return *place;
}

double solid_angle_of_circle(double radius_rad) {
  return 2.0 * std::numbers::pi * (1.0 - std::cos(radius_rad));
}

struct Candidate {
  ProposedObject proposed;
  Vec3 direction{0.0F};
  double score = 0.0;
};

std::optional<Candidate> candidate(const LoadedScene& loaded, const Group& group, const Seen& seen,
                                   const View& view, const ProposalRule& rule) {
  constexpr std::size_t min_rays = 12;
  if (group.shines || seen.first_met.size() < min_rays || glm::length(seen.sum) == 0.0) {
    return std::nullopt;
  }
  const auto first_met = static_cast<double>(seen.first_met.size());
  const std::size_t middle = middle_ray(seen);
  const Vec3 direction = direction_of_ray(middle);
  const double radius_rad = angular_radius_rad(seen, direction);
  const double radius_deg = degrees(radius_rad);
  const double visible_share = first_met / static_cast<double>(seen.meeting);
  const double fill =
      std::min(1.0, first_met * solid_angle_of_ray / solid_angle_of_circle(radius_rad));
  if (radius_deg < rule.least_radius_deg || radius_deg > rule.largest_radius_deg ||
      visible_share < rule.least_visible_share || fill < rule.least_fill ||
      std::abs(degrees(azimuth_elevation(direction).elevation_rad)) > rule.largest_elevation_deg) {
    return std::nullopt;
  }
  constexpr double large_enough_deg = 4.0;
  const float distance_m = view.through[middle].first_distance_m;
  const DVec3 position =
      DVec3(loaded.camera.position + distance_m * direction) + loaded.scene.origin;
  return Candidate{.proposed = {.object = {.name = group.name,
                                           .position = Vec3(position),
                                           .radius_deg = static_cast<float>(radius_deg)},
                                .visible_share = visible_share,
                                .distance_m = distance_m},
                   .direction = direction,
                   .score = visible_share * fill * std::min(1.0, radius_deg / large_enough_deg)};
}

/// Whether a gaze could distinguish the two.
bool are_apart(const Candidate& a, const Candidate& b) {
  return degrees(angle_between(a.direction, b.direction)) >
         a.proposed.object.radius_deg + b.proposed.object.radius_deg;
}

/// The best non-overlapping candidates, in order of their scores.
std::vector<ProposedObject> best_of(const std::vector<Candidate>& candidates,
                                    std::size_t max_objects) {
  std::vector<Candidate> chosen;
  std::vector<ProposedObject> proposed;
  for (const Candidate& next : candidates) {
    const bool is_apart = std::ranges::all_of(
        chosen, [&](const Candidate& better) { return are_apart(better, next); });
    if (is_apart && chosen.size() < max_objects) {
      chosen.push_back(next);
      proposed.push_back(next.proposed);
    }
  }
  return proposed;
}

}  // namespace

std::vector<ProposedObject> propose_objects(const LoadedScene& loaded, const Workers& workers,
                                            const ProposalRule& rule) {
  const Groups groups = groups_of(loaded.scene);
  const View view = look_around(loaded, groups, workers);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < groups.list.size(); ++i) {
    if (auto found = candidate(loaded, groups.list[i], view.seen[i], view, rule)) {
      candidates.push_back(*std::move(found));
    }
  }
  std::ranges::stable_sort(
      candidates, [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  return best_of(candidates, rule.max_objects);
}

}  // namespace foveola
