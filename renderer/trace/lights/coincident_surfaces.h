// Finds emissive triangles that overlap other triangles in one plane, and decides which is seen.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

/// A triangle of an object of the scene.
struct SceneTriangle {
  std::uint32_t object = 0;
  std::uint32_t triangle = 0;

  bool operator==(const SceneTriangle&) const = default;
};

/// Rays meet any of several triangles that lie in one place, as rounding has it, and every emitter
/// among them would light the scene. Here the first in the list of those that shine against a ray
/// is what the ray meets, and what lights the place that the ray comes from. Surfaces that blend
/// are left out.
class CoincidentSurfaces {
 public:
  /// The scene must outlive this object. emitters: in the order in which they are preferred.
  CoincidentSurfaces(const Scene& scene, std::span<const SceneTriangle> emitters);

  /// There are no overlaps.
  bool empty() const { return overlaps_.empty(); }

  /// What a ray along `direction` (unit length) meets in the place of `hit`, which is not a miss.
  Hit seen(const Hit& hit, const Vec3& direction) const;

  /// Whether a ray along `direction` that comes to `point` of the emitter, on a side that it shines
  /// to, sees it.
  bool is_seen(const SceneTriangle& emitter, const Vec3& point, const Vec3& direction) const;

  /// Whether is_seen() may be false.
  bool may_be_hidden(const SceneTriangle& emitter) const;

  /// How far off the emitter, in metres, no surface of its plane is in the way; 0 without overlap.
  float clearance_m(const SceneTriangle& emitter) const;

  /// A warning that names the first overlap; empty if there is none.
  std::optional<std::string> warning() const;

 private:
  struct Emitter {
    SceneTriangle place;
    DVec3 corner, side1, side2, normal;
    float tolerance_m;  ///< see TriangleOf::rounding_error
    bool double_sided;
    bool has_opacity;
  };
  /// Of one triangle with emitters.
  struct Overlap {
    std::vector<std::uint32_t> emitters;  ///< itself among them if it is one; ascending
    float clearance_m = 0.0F;
  };
  struct Hash {
    std::size_t operator()(const SceneTriangle& t) const {
      return std::hash<std::uint64_t>{}(std::uint64_t{t.object} << 32 | t.triangle);
    }
  };

  void add_overlaps(const SceneTriangle& place, std::span<const std::uint32_t> near);
  const Overlap* overlap_of(const SceneTriangle& place) const;
  static bool overlaps(const Emitter& emitter, const Emitter& other);
  Emitter emitter_of(const SceneTriangle& place) const;
  bool shines(const Emitter& emitter, const Vec3& direction) const;
  /// The point's barycentric coordinates if the emitter is there.
  std::optional<Vec2> find(const Emitter& emitter, const DVec3& point) const;

  const Scene& scene_;
  std::vector<Emitter> emitters_;
  std::vector<bool> is_concerned_;  ///< by object
  std::unordered_map<SceneTriangle, Overlap, Hash> overlaps_;
  std::optional<std::pair<SceneTriangle, SceneTriangle>> first_;
};

}  // namespace foveola
