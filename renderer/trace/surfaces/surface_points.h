// Computes the geometry of surface points from hits, eight at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/trace/surfaces/triangle.h"

namespace foveola {

/// An object of a scene.
struct ObjectView {
  const Mesh* mesh;
  const Instance* instance;  ///< null for a mesh that is not instanced
};

/// SurfacePoint without material values.
struct SurfacePoints : SurfaceGeometryOf<Floats> {
  Floats double_area;  ///< twice the triangle's area, in square metres

  Vec3 smooth_normal_at(std::size_t lane) const {
    return {smooth_normal.x[lane], smooth_normal.y[lane], smooth_normal.z[lane]};
  }
  /// Applies a normal map's result to the shading normal, unless that faces away from the ray.
  void turn_shading_normal(std::size_t lane, const Vec3s& direction, const Vec3& mapped);
};

/// Collects eight hits, then evaluates all at once. Results of unset lanes are undefined.
class SurfaceHits {
 public:
  void put(std::size_t lane, const ObjectView& object, std::uint32_t triangle);

  /// direction: of the rays, unit length. barycentric, distance: see Hit.
  SurfacePoints points(const Vec3s& direction, const Vec2s& barycentric,
                       const Floats& distance) const;

 private:
  struct Corners {
    Vec3Lanes p0, p1, p2;

    template <typename Triangle>
    void put(std::size_t lane, const Triangle& triangle) {
      p0.put(lane, triangle.p0);
      p1.put(lane, triangle.p1);
      p2.put(lane, triangle.p2);
    }
  };

  void expect_instances();
  TriangleOf<Floats> triangles() const;
  Vec3s front_normal(const TriangleOf<Floats>::Front& front) const;

  std::uint32_t filled_ = 0;  ///< one bit per lane
  Corners corners_{};
  Corners normals_{};  ///< zero if the mesh has none
  bool has_instances_ = false;
  FloatLanes largest_term_, roundings_, winding_;  ///< used only with instances: see TriangleOf
};

}  // namespace foveola
