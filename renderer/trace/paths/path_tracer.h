// Radiance along rays: a unidirectional path tracer with next-event estimation.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/sample_job.h"
#include "renderer/base/work/parallel.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_sampling.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

inline constexpr int default_vertices_before_roulette = 1;
inline constexpr int no_roulette = std::numeric_limits<int>::max();

struct TraceSettings {
  int max_depth = 8;  ///< surface vertices with next-event estimation; 1 is direct light only
  std::uint32_t seed = 0;
  /// The angle of a pixel of the film, over part of which textures are averaged; 0 reads them at
  /// their finest.
  float pixel_angle_rad = 0.0F;
  /// Each channel of a sample is cut to this. Anything but infinity makes pictures too dark.
  float largest_radiance = std::numeric_limits<float>::infinity();
  /// As largest_radiance, of what each light sample gives to a path. Anything but infinity makes
  /// every vertex take the general path.
  float largest_light_sample = std::numeric_limits<float>::infinity();
  /// After how many vertices dim paths begin to be ended at random.
  int vertices_before_roulette = default_vertices_before_roulette;
  /// Without multiple importance sampling: light samples count in full, and what scattered rays
  /// meet counts only where no light sample finds it. Every vertex then takes the general path.
  bool light_samples_alone = false;
  /// Every vertex takes the general path: for measuring what the fast path gains.
  bool uses_general_path = false;
};

/// Rays traced, by kind.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t bounce = 0;
  std::uint64_t shadow = 0;
  std::uint64_t transmittance = 0;  ///< along shadow rays, through thin surfaces and glass
  std::uint64_t total() const { return primary + bounce + shadow + transmittance; }
};

/// The rays themselves, of each kind in the order of their tracing.
struct RayLog {
  std::vector<Ray> primary;
  std::vector<Ray> bounce;
  std::vector<Ray> shadow;
  std::vector<Ray> transmittance;
};

/// What a ray from the gaze meets first.
struct Picked {
  std::uint32_t object = 0;  ///< see Scene's numbering
  int material = 0;          ///< index into Scene::materials
  Vec3 position{0.0F};
  float distance_m = 0.0F;
};

/// One step of a path, as it arrived.
struct PathVertex {
  int number = 0;  ///< counted from 1; thin transmissive surfaces passed on the way repeat it
  std::optional<std::uint32_t> object;  ///< empty: the ray left the scene
  Vec3 direction{0.0F};                 ///< direction of the ray that led here
  float distance_m = 0.0F;
  Vec3 position{0.0F};
  Vec3 normal{0.0F};  ///< shading normal
  Rgb throughput{0.0F};
  Rgb radiance{0.0F};  ///< gathered up to here, without this vertex's shadow ray
  float pdf = 0.0F;    ///< per steradian, of the direction; infinite for a camera's or mirror's
};

struct PathRecord {
  std::vector<PathVertex> vertices;
  Rgb radiance{0.0F};
};

/// A scene ready to be traced. It refers to the Scene it was built from, which must outlive it.
/// All calls are const and may be made from several threads.
class PathTracer {
 public:
  /// kept: see RayScene.
  PathTracer(const Scene& scene, const Workers& workers, const LightSampling& lights = {},
             KeptHierarchies* kept = nullptr);
  ~PathTracer();
  PathTracer(PathTracer&&) noexcept;
  PathTracer& operator=(PathTracer&&) noexcept;

  /// Writes the radiance that arrives at `viewpoint` along each job's direction. radiance has as
  /// many elements as jobs. Each value depends on its job, the viewpoint and the settings only; a
  /// value may be non-finite when the transport failed numerically, and the film drops it.
  /// Neighbouring jobs should have neighbouring directions.
  RayCounts trace(const Vec3& viewpoint, std::span<const SampleJob> jobs, std::span<Rgb> radiance,
                  const TraceSettings& settings, const Workers& workers) const;

  /// Traces some paths from the viewpoint in all directions, always the same, and from then on
  /// draws light by what arrived on them; only where there is something to learn that helps. To be
  /// called once, before all tracing.
  void learn_lights(const Vec3& viewpoint, const Workers& workers);

  /// One job again, with all its vertices; its radiance is that of trace(), to the bit.
  PathRecord replay(const Vec3& viewpoint, const SampleJob& job,
                    const TraceSettings& settings) const;

  /// The rays that trace() asks Embree about, block after block of the jobs.
  RayLog log_rays(const Vec3& viewpoint, std::span<const SampleJob> jobs,
                  const TraceSettings& settings) const;

  /// What about the scene's lights is not as the file may mean it: a line each.
  std::vector<std::string> warnings() const;

  /// What the rays are traced against.
  const RayScene& ray_scene() const;

  /// The first surface along a ray; empty if there is none.
  std::optional<Picked> pick(const Vec3& origin, const Vec3& direction) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace foveola
