// What there is around a point, as found by rays in all directions; whether a scene is a room to
// stand in, and where in it.
#pragma once

#include <optional>
#include <vector>

#include "renderer/progressive/standpoint.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Point `index` of `count` spherical Fibonacci points, which lie evenly on the unit sphere
/// (Marques et al., Spherical Fibonacci Point Sets for Illumination Integrals, 2013).
Vec3 fibonacci_direction(int index, int count);

struct Surroundings {
  double share_hit = 0.0;  ///< of the rays, in [0, 1]
  double share_fronts =
      0.0;  ///< of what was hit: seen from its front, by its winding; 0 if nothing
  /// Geometric mean of the distances, of at most the largest that was asked for. Metres.
  double space_m = 0.0;
};

/// rays_count: of rays, evenly in all directions. What is missed or further than `furthest_m`
/// counts as being there.
Surroundings look_around(const Scene& scene, const RayScene& rays, const Vec3& from, int rays_count,
                         double furthest_m);

/// The share of fronts among what is met first on the way to `target` from all around, from
/// `distance_m` away; 1 if nothing is.
double share_of_fronts_from_outside(const Scene& scene, const RayScene& rays, const Vec3& target,
                                    double distance_m);

/// Whether something is in the way in all directions, as far as 256 rays can tell.
bool is_enclosed(const RayScene& rays, const Vec3& from);

/// Whether a point or spot light is in sight.
bool is_light_in_sight(const Scene& scene, const RayScene& rays, const Vec3& from);

/// What one ray of a picture meets.
struct SightLine {
  Vec3 direction{0.0F};  ///< unit length
  Hit hit;
};

/// The rays through the middles of a picture's cells, row after row from the top left.
std::vector<SightLine> sight_lines(const RayScene& rays, const Vec3& from, const Viewport& viewport,
                                   const IVec2& cells);

/// Whether what a ray met was met on its front.
bool is_front(const Scene& scene, const Hit& hit, const Vec3& direction);

/// The place in a room that choose_standpoint describes; none if the scene is no room.
std::optional<Standpoint> standpoint_in_room(const Scene& scene, const RayScene& rays,
                                             const Bounds& bounds,
                                             const FieldOfView& field_of_view);

}  // namespace foveola
