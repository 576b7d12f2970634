// Finds emissive triangles that overlap coplanar triangles, and decides which of them is visible.
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

/// Where several triangles coincide, rounding decides which one a ray hits, and every emitter among
/// them would light the scene. Here the first listed triangle that emits against a ray is both the
/// one hit and the only emitter. Alpha-blended surfaces are left out.
class CoincidentSurfaces {
 public:
  /// The scene must outlive this object. emitters: in order of preference.
  CoincidentSurfaces(const Scene& scene, std::span<const SceneTriangle> emitters);

  /// Whether there are no overlaps.
  bool empty() const { return overlaps_.empty(); }

  /// The visible hit at the place of `hit`, which is not a miss, along `direction` (unit length).
  Hit seen(const Hit& hit, const Vec3& direction) const;

  /// Whether a ray along `direction` to `point` of the emitter, on an emitting side, sees the
  /// emitter.
  bool is_seen(const SceneTriangle& emitter, const Vec3& point, const Vec3& direction) const;

  /// Whether is_seen() may be false.
  bool may_be_hidden(const SceneTriangle& emitter) const;

  /// Distance from the emitter, in metres, beyond which nothing coincides; 0 without overlap.
  float clearance_m(const SceneTriangle& emitter) const;

  /// A warning that names the first overlap; nullopt if there is none.
  std::optional<std::string> warning() const;

 private:
  struct Emitter {
    SceneTriangle place;
    DVec3 corner, side1, side2, normal;
    float tolerance_m;  ///< see TriangleOf::rounding_error
    bool double_sided;
    bool has_opacity;
  };
  /// The emitters at one triangle.
  struct Overlap {
    std::vector<std::uint32_t> emitters;  ///< including itself if it emits; ascending
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
  /// The point's barycentric coordinates on the emitter; nullopt if it lies outside.
  std::optional<Vec2> find(const Emitter& emitter, const DVec3& point) const;

  const Scene& scene_;
  std::vector<Emitter> emitters_;
  std::vector<bool> is_concerned_;  ///< by object
  std::unordered_map<SceneTriangle, Overlap, Hash> overlaps_;
  std::optional<std::pair<SceneTriangle, SceneTriangle>> first_;
};

}  // namespace foveola
