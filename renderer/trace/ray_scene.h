// The triangles of a scene, ready for rays. Everything that is Embree's stays behind this header.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "renderer/base/parallel.h"
#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/kept_hierarchies.h"

struct RTCSceneTy;

namespace foveola {

/// The points origin + t * direction for t in (t_min, t_max). Laid out as Embree's single ray, so
/// that streams of them need no copy.
struct alignas(16) Ray {
  Vec3 origin{0.0F};
  float t_min = 0.0F;
  Vec3 direction{0.0F};
  float time = 0.0F;
  float t_max = std::numeric_limits<float>::infinity();
  std::uint32_t mask = ~0U;
  std::uint32_t key = 0;    ///< random; decides which blended surfaces the ray meets
  std::uint32_t flags = 0;  ///< set by find_blocked(): it met a thin transmissive surface

  bool is_blocked() const { return t_max < 0.0F; }
  bool met_thin_surface() const { return flags != 0; }
};

/// Where a ray met a triangle: at (1 - u - v) * p0 + u * p1 + v * p2 with barycentric = (u, v).
struct Hit {
  static constexpr std::uint32_t nothing = ~0U;

  float t = std::numeric_limits<float>::infinity();
  Vec2 barycentric{0.0F};
  std::uint32_t object = nothing;  ///< see Scene's numbering
  std::uint32_t triangle = 0;      ///< index into its mesh's triangles

  bool missed() const { return object == nothing; }
};

/// In an instance, geometries are numbered anew.
inline std::uint32_t object_number(std::uint32_t instance, std::uint32_t geometry) {
  return instance == Hit::nothing ? geometry : instance;
}

/// A ray on its way to the first triangle on it. Laid out as Embree's single ray with its hit, so
/// that it need not be copied: what was just written piece by piece is slow to read as a whole.
struct alignas(16) HitQuery {
  Ray ray;
  Vec3 normal;  ///< Embree's, which nothing reads
  float u, v;
  std::uint32_t triangle, geometry, instance;

  HitQuery() = default;
  explicit HitQuery(const Ray& wanted) { ask(wanted); }
  void ask(const Ray& wanted) {
    ray = wanted;
    geometry = Hit::nothing;
    instance = Hit::nothing;
  }

  Hit hit() const {
    if (geometry == Hit::nothing) {
      return {};
    }
    return {.t = ray.t_max,
            .barycentric = {u, v},
            .object = object_number(instance, geometry),
            .triangle = triangle};
  }
};

/// Answers depend on the ray alone, to the bit: not on the rays that are traced with it, nor on the
/// number of threads that built the scene. A ray meets a surface with the probability of its
/// opacity, as decided by the ray's key. Non-finite triangles are never hit.
///
/// There are no coherent packets for closest hits on purpose. With Embree 3.13 they are twice as
/// fast for neighbouring rays, but where two triangles are hit at the same distance (coplanar
/// overlaps, shared edges) the winner changes with the packet's other rays.
class RayScene {
 public:
  /// The scene must outlive this object. kept: where the hierarchies of its prototypes are found
  /// and left, or null. Throws Error when Embree fails, for lack of memory or an unsupported
  /// processor.
  RayScene(const Scene& scene, const Workers& workers, KeptHierarchies* kept = nullptr);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// The first triangle on the ray; Hit::t is in multiples of direction's length.
  Hit closest_hit(const Ray& ray) const;
  Hit closest_hit(const Vec3& origin, const Vec3& direction) const {
    return closest_hit(Ray{.origin = origin, .direction = direction});
  }
  /// The same for each of the queries.
  void find_hits(std::span<HitQuery> queries) const;

  /// The first triangle on the ray where the opacity is above 0, whatever the ray's key.
  Hit closest_hit_of_any_opacity(const Ray& ray) const;

  /// Marks the rays that meet a triangle as blocked. Thin transmissive surfaces (see opacity.h) do
  /// not block but tint, so the rays that met one are marked too. The rays' order does not matter.
  void find_blocked(std::span<Ray> rays) const;

  /// Whether rays' keys decide something: there are surfaces that only some rays meet.
  bool asks_for_keys() const;

  /// What Embree keeps: its hierarchy and its copy of the vertices; of all that share `kept`.
  std::size_t memory_bytes() const;

  /// The scene that it was built of.
  const Scene& scene() const;
  /// Embree's own scene, for measuring Embree alone.
  RTCSceneTy* embree_scene() const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace foveola
