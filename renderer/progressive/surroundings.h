// Explores a scene around a point by rays in all directions: whether it is a room, and where to
// stand in it.
#pragma once

#include <optional>
#include <vector>

#include "renderer/progressive/standpoint.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Point `index` of `count` spherical Fibonacci points, evenly distributed on the unit sphere
/// (Marques et al., Spherical Fibonacci Point Sets for Illumination Integrals, 2013).
Vec3 fibonacci_direction(int index, int count);

struct Surroundings {
  double share_hit = 0.0;     ///< of the rays, in [0, 1]
  double share_fronts = 0.0;  ///< share of hits on front faces, by winding; 0 without hits
  /// Geometric mean of the distances, clamped to the given maximum. Metres.
  double space_m = 0.0;
};

/// rays_count: number of rays, evenly in all directions. Misses and hits beyond `furthest_m` count
/// as at that distance.
Surroundings look_around(const Scene& scene, const RayScene& rays, const Vec3& from, int rays_count,
                         double furthest_m);

/// Share of front faces among the first hits towards `target` from all around, from `distance_m`
/// away; 1 without hits.
double share_of_fronts_from_outside(const Scene& scene, const RayScene& rays, const Vec3& target,
                                    double distance_m);

/// Whether all of 256 rays hit something.
bool is_enclosed(const RayScene& rays, const Vec3& from);

/// Whether a point or spot light is visible.
bool is_light_in_sight(const Scene& scene, const RayScene& rays, const Vec3& from);

/// One ray of a picture, with its hit.
struct SightLine {
  Vec3 direction{0.0F};  ///< unit length
  Hit hit;
};

/// The rays through the centres of a picture's cells, row by row from the top left.
std::vector<SightLine> sight_lines(const RayScene& rays, const Vec3& from, const Viewport& viewport,
                                   const IVec2& cells);

/// Whether a ray hit a front face.
bool is_front(const Scene& scene, const Hit& hit, const Vec3& direction);

/// The place in a room that choose_standpoint describes; nullopt if the scene is not a room.
std::optional<Standpoint> standpoint_in_room(const Scene& scene, const RayScene& rays,
                                             const Bounds& bounds,
                                             const FieldOfView& field_of_view);

}  // namespace foveola
