// The transport of light: paths from the camera, one vertex of all of a block's paths after the
// other, and of surfaces on the fast path eight vertices at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/lanes.h"
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

/// Where to note what was traced; null: it is not noted.
struct TraceNotes {
  std::vector<PathVertex>* vertices = nullptr;
  RayLog* rays = nullptr;
  /// Of all light samples. Every vertex then takes the general path.
  std::vector<LightOutcome>* light_outcomes = nullptr;
};

/// Traces one block of jobs. renderer/MATERIALS.md says what happens at each kind of surface.
class BlockTracer {
 public:
  /// Jobs in a block, so few that the state of all paths stays in the second-level cache.
  static constexpr std::size_t max_paths = PathStates::capacity;

  /// The scene, and what is noted, must outlive this object.
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
  /// What a job gains if its shadow ray is not blocked.
  struct PendingLight {
    std::uint32_t job;
    Rgb radiance;
    bool is_towards_sun = false;  ///< to be followed through glass
  };

  /// Where paths have arrived, eight at most, from the one at `first` on.
  struct Group {
    std::size_t first;
    std::size_t size;

    LaneMask lanes() const { return mask_of((1U << size) - 1U); }
  };
  /// The surfaces that a group's paths have arrived at, those of misses without any trait.
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
  /// Fetches what the next group will need into the cache.
  void prefetch_group(std::size_t first) const;
  /// Where rays that ask for their closest hit are counted, and where they are noted.
  std::uint64_t& ray_count() { return vertex_ == 1 ? counts_.primary : counts_.bounce; }
  void note(const Ray& ray);
  /// The hit of a single ray, of coincident surfaces that which is seen.
  Hit closest_hit(const Ray& ray) const;
  const TracedObject& object_of(const Hit& hit) const { return traced_.objects[hit.object]; }
  /// What the path `index` hit.
  const TracedObject& object_at(std::size_t index) const {
    return traced_.objects[hits_->object[index]];
  }

  /// Gathers light where a group's paths have arrived, and sends them on. Returns those that go on.
  LaneMask advance(const Group& group);
  NeededNumbers needed_numbers() const;
  Surfaces surfaces_of(const Group& group) const;
  /// The paths that are in a solid that absorbs.
  LaneMask in_absorption(const Group& group) const;
  /// Adds what shines where a group's paths have arrived. Returns those that do not end there.
  LaneMask arrive(const Group& group, const Surfaces& surfaces, const LaneMask& absorbed);
  /// Adds what shines where a path has arrived. False if the path ends there.
  bool gather(Path& path, const Hit& hit);
  /// Whether no vertex follows the one on the object.
  bool is_last(const TracedObject& object) const;
  void add_environment(const Path& path);
  void add_emission(const Path& path, const Hit& hit);
  /// Adds the spheres of points and spots before the hit.
  void add_spheres(const Path& path, const Hit& hit);

  /// Sends the paths at vertices of any kind on, one by one.
  LaneMask advance_alone(const Group& group, const LaneMask& lanes, const GroupNumbers& numbers);
  bool advance_alone(std::size_t index, VertexNumbers numbers);
  /// Estimates the light that arrives at the vertex, and sends the path on.
  Step scatter(Path& path, const Hit& hit, const TracedObject& object,
               const VertexNumbers& numbers);
  void queue_light(const Path& path, const Hit& hit, const SurfacePoint& point,
                   const ShadingPoint& shading_point, const Frame& frame, const Bsdf& bsdf,
                   const TracedObject& object, const VertexNumbers& numbers);
  /// False if the path ends: its direction lies on one side of the shading normal and on the other
  /// side of the surface, or something of it is not finite.
  bool send(Path& path, const Hit& hit, const SurfacePoint& point,
            const ShadingPoint& shading_point, const Frame& frame, const BsdfSample& sample,
            const TracedObject& object);
  /// Moves the origin of a ray that leaves a triangle below its plane, but above the horizon of the
  /// smooth surface, to that surface. False if it is not above the triangle, or something is in
  /// between.
  bool lift_origin(const Hit& hit, const Vec3& geometric_normal, Vec3& origin);
  /// Whether a job's new values are finite; if not, its radiance becomes not_a_number.
  bool finite(std::uint32_t job, const Rgb& radiance, const Vec3& direction);
  /// With which weight what arrives from infinity counts once the path has left the object's
  /// surface as a perfect mirror or lens. Light samples in the disc of a sun are followed through
  /// the glass that is in their way, by glass_transmittance(); so a path that leaves the last other
  /// vertex in such a direction shares with them what it finds behind glass alone.
  float distant_weight_beyond(const Path& path, const TracedObject& object) const;
  bool survives_roulette(Path& path, float u) const;

  /// Sends the paths at surfaces on the fast path on, all at once.
  LaneMask advance_on_fast_path(const Group& group, LaneMask lanes, const LaneMask& normal_mapped,
                                const GroupNumbers& numbers);
  /// others: lanes whose surface turns out to need the general path.
  FastPathLayersLanes layers_of(const Group& group, const SurfacePoints& points,
                                const LaneMask& lanes, LaneMask& others) const;
  MeshPoint mesh_point(std::size_t index, const SurfacePoints& points, std::size_t lane) const;
  /// lanes: those whose surface has a normal map.
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

  /// The lanes whose new values are finite, as above.
  LaneMask finite(const Group& group, const LaneMask& lanes, const Vec3s& radiance,
                  const Vec3s& direction);

  void add_unblocked_light();
  /// What arrives along a job's blocked shadow ray to a sun by smooth glass and thin surfaces
  /// alone, as a share of what would arrive without them. One random walk, as of paths.
  Rgb glass_transmittance(const Ray& shadow_ray, std::uint32_t job);
  /// What the thin transmissive surfaces on an unblocked shadow ray let through.
  Rgb thin_transmittance(Ray ray);
  Ray shadow_ray(std::size_t i) const;
  void note(const Path& path, const Hit& hit) const;

  const TracedScene& traced_;
  const TraceSettings settings_;
  const bool takes_general_path_;  ///< at every vertex
  /// As how many light samples one counts in the power heuristic (Veach 1997, section 9.2: n_i).
  const float light_samples_weighed_;
  TraceNotes notes_;
  std::span<Rgb> radiance_;  ///< gathered so far, one a job
  int vertex_ = 0;           ///< the one that the active paths are on their way to; the first is 1
  std::size_t active_ = 0;   ///< paths
  std::unique_ptr<PathStates> paths_;
  std::unique_ptr<PathHits> hits_;
  RayStream shadow_rays_;
  std::vector<PendingLight> pending_;          ///< one a shadow ray
  std::vector<std::size_t> pending_outcomes_;  ///< that wait for them, where they are noted
  RayCounts counts_;
};

}  // namespace foveola
