// Path tracing of a block: one vertex of all paths after the other, eight vertices at a time for
// surfaces on the fast path.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/lanes.h"
#include "renderer/base/sample_job.h"
#include "renderer/trace/materials/bsdf.h"
#include "renderer/trace/materials/fast_path_bsdf.h"
#include "renderer/trace/paths/path_states.h"
#include "renderer/trace/paths/path_tracer.h"
#include "renderer/trace/paths/traced_scene.h"
#include "renderer/trace/paths/vertex_rules.h"
#include "renderer/trace/surfaces/surface.h"
#include "renderer/trace/surfaces/surface_points.h"

namespace foveola {

/// Destinations of notes about traced paths; null: not noted.
struct TraceNotes {
  std::vector<PathVertex>* vertices = nullptr;
  RayLog* rays = nullptr;
  /// Of all light samples. Every vertex then takes the general path.
  std::vector<LightOutcome>* light_outcomes = nullptr;
};

/// Traces one block of jobs. renderer/MATERIALS.md describes each kind of surface.
class BlockTracer {
 public:
  /// Maximum number of jobs in a block; the state of all paths fits the second-level cache.
  static constexpr std::size_t max_paths = PathStates::capacity;

  /// The scene and the destinations of notes must outlive this object.
  BlockTracer(const TracedScene& traced, const TraceSettings& settings, TraceNotes notes = {})
      : traced_(traced),
        settings_(settings),
        takes_general_path_(settings.uses_general_path || notes.light_outcomes != nullptr ||
                            settings.light_samples_alone ||
                            settings.largest_light_sample < std::numeric_limits<float>::infinity()),
        light_samples_weighed_(settings.light_samples_alone ? overwhelmingly_many : 1.0F),
        notes_(notes),
        paths_(std::make_unique_for_overwrite<PathStates>()),
        hits_(std::make_unique_for_overwrite<PathHits>()),
        shadow_rays_(max_paths) {
    pending_.reserve(max_paths);
  }

  /// To be called once, for at most max_paths jobs.
  RayCounts trace(const Vec3& viewpoint, std::span<const SampleJob> jobs, std::span<Rgb> radiance);

 private:
  /// The contribution to a job if its shadow ray is not blocked.
  struct PendingLight {
    std::uint32_t job;
    Rgb radiance;
    bool is_distant;  ///< from infinity, and not of a delta light
  };

  /// The hits of at most eight paths, from the one at `first`.
  struct Group {
    std::size_t first;
    std::size_t size;

    LaneMask lanes() const { return mask_of((1U << size) - 1U); }
  };
  /// Traits of the surfaces hit by a group's paths; misses have none.
  struct Surfaces {
    LaneMask shining, thin_transmissive, on_fast_path, normal_mapped;
  };
  enum class Step : std::uint8_t { ended, scattered, passed };

  void start(const Vec3& viewpoint, std::span<const SampleJob> jobs);
  /// The group of active paths that begins at `first`.
  Group group_at(std::size_t first) const {
    return {.first = first, .size = std::min(lane_count, active_ - first)};
  }
  void find_hits();
  /// Prefetches the next group's data into the cache.
  void prefetch_group(std::size_t first) const;
  /// The counter of closest-hit rays at this vertex, and their log.
  std::uint64_t& ray_count() { return vertex_ == 1 ? counts_.primary : counts_.bounce; }
  void note(const Ray& ray);
  /// The hit of a single ray; of coincident surfaces the visible one.
  Hit closest_hit(const Ray& ray) const;
  const TracedObject& object_of(const Hit& hit) const { return traced_.objects[hit.object]; }
  /// The object that path `index` hit.
  const TracedObject& object_at(std::size_t index) const {
    return traced_.objects[hits_->object[index]];
  }

  /// Gathers light at the hits of a group's paths. Returns the paths that continue.
  LaneMask advance(const Group& group);
  NeededNumbers needed_numbers() const;
  Surfaces surfaces_of(const Group& group) const;
  /// The paths inside an absorbing solid.
  LaneMask in_absorption(const Group& group) const;
  /// Adds emitted radiance at the hits of a group's paths. Returns the paths that do not end there.
  LaneMask arrive(const Group& group, const Surfaces& surfaces, const LaneMask& absorbed);
  /// Adds emitted radiance at the path's hit. False if the path ends there.
  bool gather(Path& path, const Hit& hit);
  /// Whether the vertex on the object is the path's last.
  bool is_last(const TracedObject& object) const;
  void add_environment(const Path& path);
  void add_emission(const Path& path, const Hit& hit);
  /// Adds the spheres of points and spots in front of the hit.
  void add_spheres(const Path& path, const Hit& hit);

  /// Continues the paths at vertices of any kind, one by one.
  LaneMask advance_alone(const Group& group, const LaneMask& lanes, const GroupNumbers& numbers);
  bool advance_alone(std::size_t index, VertexNumbers numbers);
  /// Estimates the direct light at the vertex, and continues the path.
  Step scatter(Path& path, const Hit& hit, const TracedObject& object,
               const VertexNumbers& numbers);
  void queue_light(const Path& path, const Hit& hit, const SurfacePoint& point,
                   const ShadingPoint& shading_point, const Frame& frame, const Bsdf& bsdf,
                   const TracedObject& object, const VertexNumbers& numbers);
  /// False if the path ends: its direction lies on different sides of the shading normal and the
  /// surface, or it has non-finite values.
  bool send(Path& path, const Hit& hit, const SurfacePoint& point,
            const ShadingPoint& shading_point, const Frame& frame, const BsdfSample& sample,
            const TracedObject& object);
  /// Moves a ray's origin to the smooth surface if the ray leaves below the triangle's plane but
  /// above the smooth surface's horizon. False if it is below both, or if the way is blocked.
  bool lift_origin(const Hit& hit, const Vec3& geometric_normal, Vec3& origin);
  /// Whether a job's new values are finite; otherwise its radiance becomes not_a_number.
  bool finite(std::uint32_t job, const Rgb& radiance, const Vec3& direction);
  /// Weight of radiance from infinity after the path leaves the object as a perfect mirror or lens.
  /// Light samples of a sun's disc are followed through glass by glass_transmittance(). A path
  /// whose last other vertex sent it towards a sun therefore shares with them the light that it
  /// finds behind glass alone.
  float distant_weight_beyond(const Path& path, const TracedObject& object) const;
  bool survives_roulette(Path& path, float u) const;

  /// Continues the paths at surfaces on the fast path, all at once.
  LaneMask advance_on_fast_path(const Group& group, LaneMask lanes, const LaneMask& normal_mapped,
                                const GroupNumbers& numbers);
  /// others: receives the lanes whose surface needs the general path after all.
  FastPathLayersLanes layers_of(const Group& group, const SurfacePoints& points,
                                const LaneMask& lanes, LaneMask& others) const;
  MeshPoint mesh_point(std::size_t index, const SurfacePoints& points, std::size_t lane) const;
  /// lanes: surfaces with a normal map.
  void apply_normal_maps(const Group& group, const Vec3s& direction, const LaneMask& lanes,
                         SurfacePoints& points) const;
  void queue_lights(const Group& group, const LaneMask& lanes, const SurfacePoints& points,
                    const ShadingPoints& shading_points, const Frames& frames,
                    const FastPathBsdfs& bsdfs, const GroupNumbers& numbers);
  /// The lanes whose rays can leave in `direction`, which is above the horizon; lifts their
  /// origins.
  LaneMask lift_origins(const Group& group, LaneMask lanes, const Vec3s& direction,
                        const SurfacePoints& points, Vec3s& origin);
  LaneMask send(const Group& group, const LaneMask& lanes, const SurfacePoints& points,
                const ShadingPoints& shading_points, const Frames& frames,
                const FastPathBsdfs& bsdfs, const GroupNumbers& numbers);

  /// The lanes whose new values are finite, as finite() above.
  LaneMask finite(const Group& group, const LaneMask& lanes, const Vec3s& radiance,
                  const Vec3s& direction);

  void add_unblocked_light();
  /// Transmittance of a blocked shadow ray to a sun through smooth glass and thin surfaces alone; 0
  /// if anything else blocks it. Estimated by one random walk.
  Rgb glass_transmittance(const Ray& shadow_ray, std::uint32_t job);
  /// Transmittance of the thin surfaces on an unblocked shadow ray.
  Rgb thin_transmittance(Ray ray);
  Ray shadow_ray(std::size_t i) const;
  void note(const Path& path, const Hit& hit) const;

  const TracedScene& traced_;
  const TraceSettings settings_;
  const bool takes_general_path_;  ///< at every vertex
  /// Number of light samples that one counts as in the power heuristic (Veach 1997, 9.2: n_i).
  const float light_samples_weighed_;
  TraceNotes notes_;
  std::span<Rgb> radiance_;  ///< gathered so far, one per job
  int vertex_ = 0;           ///< the vertex that the active paths approach; the first is 1
  std::size_t active_ = 0;   ///< number of paths
  std::unique_ptr<PathStates> paths_;
  std::unique_ptr<PathHits> hits_;
  RayStream shadow_rays_;
  std::vector<PendingLight> pending_;          ///< one per shadow ray
  std::vector<std::size_t> pending_outcomes_;  ///< outcomes awaiting their shadow rays, if noted
  RayCounts counts_;
};

}  // namespace foveola
