// The triangles of a scene, ready for rays. Everything that is Embree's stays behind this header.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/base/work/parallel.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_stream.h"

struct RTCSceneTy;

namespace foveola {

/// Scenes that are built with the same one of these share the hierarchies of prototypes whose
/// triangles are the same, and build only what is new. It keeps those of the scene that was built
/// last; scenes keep what they use, and may outlive it. For one scene at a time.
class KeptHierarchies {
 public:
  KeptHierarchies();
  ~KeptHierarchies();
  KeptHierarchies(const KeptHierarchies&) = delete;
  KeptHierarchies& operator=(const KeptHierarchies&) = delete;

  /// Hierarchies of prototypes that were built, not found, in all scenes so far.
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
  std::uint32_t key = 0;  ///< random; decides which blended surfaces the ray meets
  std::uint32_t flags = 0;
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

/// Eight rays, laid out as Embree's packet of so many.
struct RayLanes {
  Vec3Lanes origin;
  FloatLanes t_min;
  Vec3Lanes direction;
  FloatLanes time;
  FloatLanes t_max;
  UintLanes mask;
  UintLanes key;
  UintLanes flags;

  /// Rays without end.
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

/// Eight rays on their way to the first triangle on them, laid out as Embree's packet of so many.
struct HitQueries {
  RayLanes rays;
  Vec3Lanes normal;  ///< Embree's, which nothing reads
  FloatLanes u, v;
  UintLanes triangle, geometry, instance;
  UintLanes instance_part;  ///< Embree 4's, which nothing reads

  explicit HitQueries(const RayLanes& wanted) : rays(wanted) {
    geometry.fill(Hit::nothing);
    instance.fill(Hit::nothing);
  }

  /// Hit::object of all.
  Uints object() const {
    const Uints instances = instance.load();
    return instances == Hit::nothing ? geometry.load() : instances;
  }
};

/// Answers depend on the ray alone, to the bit: not on the rays that are traced with it, nor on the
/// number of threads that built the scene. A ray meets a surface with the probability of its
/// opacity, as decided by the ray's key. Non-finite triangles are never hit.
///
/// Eight rays go to Embree together but are traced one by one ("incoherent"), which with
/// Embree 3.13 takes as long as single rays less the cost of taking them apart. Packets that are
/// traced together
/// ("coherent") are twice as fast for neighbouring rays, but where two triangles are hit at the
/// same distance (coplanar overlaps, shared edges) the winner changes with the packet's other rays.
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
  /// The same for those of eight rays that have a bit in `lanes`.
  void find_hits(HitQueries& queries, const LaneMask& lanes) const;

  /// The first triangle on the ray where the opacity is above 0, whatever the ray's key.
  Hit closest_hit_of_any_opacity(const Ray& ray) const;

  /// Marks the rays that meet a triangle as blocked, and those that met thin transmissive surfaces.
  void find_blocked(RayStream& rays) const;

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
