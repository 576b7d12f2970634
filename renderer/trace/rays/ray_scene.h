// Ray queries against a scene's triangles. All use of Embree stays behind this header.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/base/work/parallel.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_stream.h"

struct RTCSceneTy;

namespace foveola {

/// Shares hierarchies of equal prototypes between successive versions of one scene, so that only
/// new ones are built. Keeps those of the last built scene. Scenes own the hierarchies that they
/// use, and may outlive this object.
class KeptHierarchies {
 public:
  KeptHierarchies();
  ~KeptHierarchies();
  KeptHierarchies(const KeptHierarchies&) = delete;
  KeptHierarchies& operator=(const KeptHierarchies&) = delete;

  /// Number of prototype hierarchies built, not reused, for all scenes so far.
  std::uint64_t built() const;

 private:
  friend class RayScene;
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

/// The points origin + t * direction for t in (t_min, t_max). Laid out as Embree's single ray.
struct alignas(16) Ray {
  Vec3 origin{0.0F};
  float t_min = 0.0F;
  Vec3 direction{0.0F};
  float time = 0.0F;
  float t_max = std::numeric_limits<float>::infinity();
  std::uint32_t mask = ~0U;
  std::uint32_t key = 0;  ///< random; decides about hits of blended surfaces
  std::uint32_t flags = 0;
};

/// A ray's hit on a triangle, at (1 - u - v) * p0 + u * p1 + v * p2 with barycentric = (u, v).
struct Hit {
  static constexpr std::uint32_t nothing = ~0U;

  float t = std::numeric_limits<float>::infinity();
  Vec2 barycentric{0.0F};
  std::uint32_t object = nothing;  ///< see Scene's numbering
  std::uint32_t triangle = 0;      ///< index into its mesh's triangles

  bool missed() const { return object == nothing; }
};

/// Geometries of an instance are numbered separately.
inline std::uint32_t object_number(std::uint32_t instance, std::uint32_t geometry) {
  return instance == Hit::nothing ? geometry : instance;
}

/// Eight rays in the layout of Embree's packet of eight.
struct RayLanes {
  Vec3Lanes origin;
  FloatLanes t_min;
  Vec3Lanes direction;
  FloatLanes time;
  FloatLanes t_max;
  UintLanes mask;
  UintLanes key;
  UintLanes flags;

  /// Rays of infinite length.
  RayLanes(const Vec3s& from, const Vec3s& along, const Uints& keys) {
    origin.store(from);
    t_min.store(Floats{});
    direction.store(along);
    time.store(Floats{});
    t_max.fill(std::numeric_limits<float>::infinity());
    mask.store(~Uints{});
    key.store(keys);
    flags.store(Uints{});
  }

  Ray at(std::size_t lane) const {
    return {.origin = origin.at(lane),
            .t_min = t_min[lane],
            .direction = direction.at(lane),
            .time = time[lane],
            .t_max = t_max[lane],
            .mask = mask[lane],
            .key = key[lane],
            .flags = flags[lane]};
  }
};

/// Closest-hit queries of eight rays, in the layout of Embree's packet of eight.
struct HitQueries {
  RayLanes rays;
  Vec3Lanes normal;  ///< written by Embree, unused
  FloatLanes u, v;
  UintLanes triangle, geometry, instance;
  UintLanes instance_part;  ///< written by Embree 4, unused

  explicit HitQueries(const RayLanes& wanted) : rays(wanted) {
    geometry.fill(Hit::nothing);
    instance.fill(Hit::nothing);
  }

  /// Hit::object of each lane.
  Uints object() const {
    const Uints instances = instance.load();
    return instances == Hit::nothing ? geometry.load() : instances;
  }
};

/// Results depend on the ray alone, to the bit: not on other rays of the call, nor on the number of
/// threads that built the scene. A ray hits a surface with the probability of its opacity, decided
/// by the ray's key. Non-finite triangles are never hit.
///
/// Eight rays go to Embree together but are traced one by one ("incoherent"). With Embree 3.13 this
/// takes as long as single rays, without the cost of separating them. Coherent packets are twice as
/// fast for neighbouring rays. But where two triangles are hit at the same distance (coplanar
/// overlaps, shared edges), the winner depends on the packet's other rays.
class RayScene {
 public:
  /// The scene must outlive this object. kept: stores hierarchies of prototypes for reuse, or null.
  /// Throws Error when Embree fails, for lack of memory or an unsupported processor.
  RayScene(const Scene& scene, const Workers& workers, KeptHierarchies* kept = nullptr);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// The first triangle on the ray; Hit::t is in multiples of the direction's length.
  Hit closest_hit(const Ray& ray) const;
  Hit closest_hit(const Vec3& origin, const Vec3& direction) const {
    return closest_hit(Ray{.origin = origin, .direction = direction});
  }
  /// The same for the rays in `lanes`.
  void find_hits(HitQueries& queries, const LaneMask& lanes) const;

  /// The first triangle on the ray with an opacity above 0, whatever the ray's key.
  Hit closest_hit_of_any_opacity(const Ray& ray) const;

  /// Marks rays that hit a triangle as blocked, and rays that passed thin transmissive surfaces.
  void find_blocked(RayStream& rays) const;

  /// Whether rays' keys matter: some surfaces are partly transparent.
  bool asks_for_keys() const;

  /// Embree's memory: hierarchies and copied vertices, of all scenes that share `kept`.
  std::size_t memory_bytes() const;

  /// The scene that it was built from.
  const Scene& scene() const;
  /// Embree's own scene, for measuring Embree alone.
  RTCSceneTy* embree_scene() const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace foveola
